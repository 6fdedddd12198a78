//! Requests of the page, at a server of their own.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use judder_explorer::{Explorer, ViewedCase};
use judder_study::Silent;
use judder_study::run::{RunOptions, run};
use serde_json::json;
use tempfile::TempDir;

use crate::{Door, Sample};

/// Bodies by the doors of the server that they are sent to; `,` stands for `/`.
fn bodies() -> Vec<Sample> {
    let range = |from: f64, to: f64| json!({ "from": from, "to": to, "points": 4 });
    let axis = |key: &str| json!({ "key": key, "from": 1e-3, "to": 1e-1, "points": 4, "scale": "log" });
    let map = json!({ "kind": "stability-map", "x": axis("operation.velocity"), "y": axis("contact.shear_strength") });
    let spectrum = json!({ "kind": "spectrum", "sweep": axis("contact.shear_strength") });
    let set = json!(["operation.velocity=0.01", "oscillator.damping_x=0.02"]);
    let all = [
        ("case", json!({ "set": set })),
        ("point", json!({ "set": set, "slot": "point" })),
        ("map", json!({ "set": set, "analysis": map, "boundaries": ["full"] })),
        ("analysis", json!({ "set": set, "analysis": spectrum })),
        ("motion", json!({ "set": set, "analysis": { "kind": "motion", "duration": 50, "points": 51 } })),
        ("law", json!({ "set": set, "velocity": range(1e-3, 1.0), "indentation": range(1e-3, 1e-1) })),
        ("export", json!({ "set": set, "analysis": spectrum })),
        ("study,case", json!({ "analysis": "spectrum" })),
        (
            "study,arrays",
            json!({ "analysis": "spectrum", "variables": ["growth_rate"], "from": 0, "to": 3, "most": 9 }),
        ),
        ("study,report", json!({ "analysis": "spectrum" })),
        ("study,shapes", json!({ "analysis": "spectrum", "at": 0.5, "count": 3 })),
    ];
    all.map(|(name, body)| (PathBuf::from(name), body.to_string().into_bytes())).to_vec()
}

/// The study that is served.
const CASE: &str = r#"
model = "oscillator"
[contact]
shear_strength = 0.005
[[analysis]]
kind = "spectrum"
sweep = { key = "contact.shear_strength", from = 1e-3, to = 1e-1, points = 4 }
"#;

/// A server that runs as long as the process, and what lets in.
struct Server {
    _study: TempDir,
    port: u16,
    cookie: String,
}

impl Server {
    fn new() -> Self {
        let study = TempDir::new().unwrap();
        let file = judder_models::parse("case.toml", CASE, &[]).unwrap();
        let options = RunOptions { without_report: true, ..RunOptions::default() };
        assert!(run(&file, study.path(), &options, &Silent).unwrap().complete);
        let viewed = ViewedCase::open(None, Some(study.path())).unwrap();
        let explorer = Explorer::new(viewed, None).unwrap();
        let address = explorer.address();
        let rest = address.strip_prefix("http://127.0.0.1:").unwrap();
        let (port, token) = rest.split_once("/enter?token=").unwrap();
        let (port, token) = (port.parse().unwrap(), token.to_owned());
        thread::spawn(move || explorer.serve(&|| false).unwrap());
        let mut this = Self { _study: study, port, cookie: String::new() };
        let entered = this.send(
            format!(
                "GET /enter?token={token} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n"
            )
            .as_bytes(),
        );
        let head = String::from_utf8(entered.unwrap()).unwrap();
        let cookie = head.lines().find_map(|line| line.strip_prefix("set-cookie: ")).unwrap();
        cookie.split(';').next().unwrap().clone_into(&mut this.cookie);
        this
    }

    fn send(&self, request: &[u8]) -> std::io::Result<Vec<u8>> {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port))?;
        stream.set_read_timeout(Some(Duration::from_secs(30)))?;
        stream.write_all(request)?;
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer)?;
        Ok(answer)
    }

    /// Sends a body; the status of the answer.
    fn post(&self, path: &str, body: &[u8]) -> Result<u16, String> {
        let (port, cookie, length) = (self.port, &self.cookie, body.len());
        let head = format!(
            "POST {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nOrigin: http://127.0.0.1:{port}\r\nCookie: {cookie}\r\n\
             Content-Type: application/json\r\nContent-Length: {length}\r\nConnection: close\r\n\r\n"
        );
        let answer = self.send(&[head.as_bytes(), body].concat()).map_err(|error| error.to_string())?;
        let line = String::from_utf8_lossy(answer.split(|byte| *byte == b'\r').next().unwrap_or_default());
        line.split(' ')
            .nth(1)
            .and_then(|status| status.parse().ok())
            .ok_or_else(|| format!("no status: {line}"))
    }
}

/// The door of the page.
pub(crate) fn door() -> Door {
    let server = Server::new();
    let post = move |path: &Path, content: &[u8]| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().replace(',', "/");
        server.post(&format!("/api/{name}"), content)
    };
    for (name, body) in bodies() {
        let status = post(&name, &body).unwrap();
        assert!(status == 200, "{}: {status}", name.display());
    }
    let reading = move |path: &Path, content: &[u8]| match post(path, content)? {
        status if status >= 500 => Err(format!("status {status}")),
        _ => Ok(()),
    };
    Door { name: "requests", samples: bodies(), tells: true, reading: Box::new(reading) }
}
