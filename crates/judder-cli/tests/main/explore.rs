//! `judder explore`: how it begins and how it ends; what it answers is tested beside its server.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, ChildStdout, Command, Stdio};

use serde_json::Value;

use crate::desk::{CASE, Desk, Said};

/// `judder explore`, which has said its address.
struct Exploring {
    child: Child,
    stdout: BufReader<ChildStdout>,
    port: u16,
    token: String,
}

fn explore(desk: &Desk, arguments: &[&str]) -> Exploring {
    let mut command = desk.command(&[&["explore", "--json", "--no-browser"], arguments].concat());
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut stdout = BufReader::new(child.stdout.take().unwrap());
    let mut document = String::new();
    while serde_json::from_str::<Value>(&document).is_err() {
        assert!(stdout.read_line(&mut document).unwrap() > 0, "it ended: {document}");
    }
    let address = serde_json::from_str::<Value>(&document).unwrap()["address"].as_str().unwrap().to_owned();
    let rest = address.strip_prefix("http://127.0.0.1:").unwrap();
    let (port, token) = rest.split_once("/enter?token=").unwrap();
    Exploring { port: port.parse().unwrap(), token: token.to_owned(), child, stdout }
}

impl Exploring {
    /// Sends a request without its `Host`, which is added.
    fn send(&self, request: &str) -> TcpStream {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        let (line, rest) = request.split_once("\r\n").unwrap();
        write!(stream, "{line}\r\nHost: 127.0.0.1:{}\r\n{rest}", self.port).unwrap();
        stream
    }

    fn cookie(&self) -> String {
        let mut answer = String::new();
        let request = format!("GET /enter?token={} HTTP/1.1\r\nConnection: close\r\n\r\n", self.token);
        self.send(&request).read_to_string(&mut answer).unwrap();
        let cookie = answer.lines().find_map(|line| line.strip_prefix("set-cookie: ")).unwrap();
        cookie.split(';').next().unwrap().to_owned()
    }

    /// Presses Ctrl-C, and waits for the end.
    fn interrupt(mut self) -> Said {
        let status = Command::new("kill").args(["-INT", &self.child.id().to_string()]).status().unwrap();
        assert!(status.success());
        let mut rest = String::new();
        self.stdout.read_to_string(&mut rest).unwrap();
        assert_eq!(rest, "", "nothing but the document stands on standard output");
        Said::of(self.child.wait_with_output().unwrap())
    }
}

#[test]
#[cfg(unix)]
fn ctrl_c_ends_it_amid_work() {
    let desk = Desk::with_case(CASE);
    let exploring = explore(&desk, &["case.toml"]);
    let body = r#"{"set":["contact.shear_strength=0.1"],"analysis":{"name":"motion","kind":"motion","duration":1e7,"points":1000000,"steps":50000000}}"#;
    let mut working = exploring.send(&format!(
        "POST /api/motion HTTP/1.1\r\nOrigin: http://127.0.0.1:{}\r\nCookie: {}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
        exploring.port,
        exploring.cookie(),
        body.len()
    ));
    let mut start = [0; 4096];
    assert!(working.read(&mut start).unwrap() > 0);
    assert!(start.starts_with(b"HTTP/1.1 200"));
    let said = exploring.interrupt();
    assert_eq!(said.code, 0, "{}", said.stderr);
    assert!(!said.stderr.contains("panicked"), "{}", said.stderr);
    assert_eq!(desk.files(), [desk.path("case.toml")], "it leaves nothing");
}

#[test]
fn what_cannot_be_explored_is_told() {
    let desk = Desk::with_case(CASE);
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    desk.refused(
        &["explore", "case.toml", "--no-browser", "--port", &port],
        "cannot listen on 127.0.0.1",
        "choose another",
    );
    desk.refused(&["explore", "nothing.toml"], "nothing.toml", "judder new");
    desk.refused(&["explore", "case.toml", "--port", "70000"], "invalid value '70000'", "--port");
    std::fs::create_dir(desk.path("empty")).unwrap();
    desk.refused(&["explore", "empty"], "empty", "judder run");
    desk.refused(&["explore", "case.toml", "--study", "empty"], "empty", "judder run");
    desk.refused(
        &["explore", "empty", "--study", "empty"],
        "is a study folder, and `--study` names another",
        "one folder alone",
    );
    desk.write("wrong.toml", "model = \"oscillator\"\n[operation]\nsped = 1\n");
    desk.refused(&["explore", "wrong.toml"], "sped", "operation");
}
