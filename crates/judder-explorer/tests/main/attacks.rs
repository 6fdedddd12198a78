//! Attacks on the door: each is turned away.

use crate::client::Served;
use serde_json::json;
use std::io::Write;
use std::net::{SocketAddr, TcpStream, UdpSocket};
use std::time::{Duration, Instant};

/// A request for the session with this head in place of the usual one.
fn with_head(served: &Served, head: &str) -> u16 {
    served.send(&format!("GET /api/session HTTP/1.1\r\n{head}Connection: close\r\n\r\n")).status
}

#[test]
fn only_this_machine_is_listened_to() {
    let served = Served::new();
    // no packet is sent: the system says which address of this machine would send it
    let outward = UdpSocket::bind("0.0.0.0:0").and_then(|socket| {
        socket.connect("192.0.2.1:9")?;
        socket.local_addr()
    });
    let Ok(address) = outward.map(|address| SocketAddr::new(address.ip(), served.port)) else {
        eprintln!("skipped in part: this machine has no address but that of the loopback");
        return;
    };
    assert!(!address.ip().is_loopback());
    assert!(TcpStream::connect_timeout(&address, Duration::from_secs(2)).is_err(), "{address} answers");
}

#[test]
fn nobody_comes_in_without_the_token() {
    let served = Served::new();
    let host = format!("Host: 127.0.0.1:{}\r\n", served.port);
    let token = &served.token;
    let words =
        ["".to_owned(), token[1..].to_owned(), format!("{token}0"), token.to_uppercase(), "0".repeat(64)];
    for word in words.iter().map(|word| format!("/enter?token={word}")).chain([
        "/enter".to_owned(),
        format!("/enter?x=1&token={token}"),
        format!("/enter?token={token}&token=x"),
    ]) {
        let answer = served.send(&format!("GET {word} HTTP/1.1\r\n{host}Connection: close\r\n\r\n"));
        assert_eq!(answer.status, 403, "{word}");
        assert!(answer.header("set-cookie").is_none());
        assert!(!answer.text().contains(token.as_str()));
    }
    for path in
        ["/", "/map", "/index.html", "/assets/x.js", "/api/session", "/api/study", "/nothing", "/favicon.ico"]
    {
        let answer = served.send(&format!("GET {path} HTTP/1.1\r\n{host}Connection: close\r\n\r\n"));
        assert_eq!(answer.status, 403, "{path}");
    }
    let body = served.send(&format!(
        "POST /enter?token={token} HTTP/1.1\r\n{host}Origin: http://127.0.0.1:{}\r\nContent-Length: 0\r\nConnection: close\r\n\r\n",
        served.port
    ));
    assert_eq!(body.status, 403);
}

#[test]
fn cookies_that_are_not_the_session_open_nothing() {
    let served = Served::new();
    let (host, own) = (format!("Host: 127.0.0.1:{}\r\n", served.port), served.cookie());
    let (name, word) = own.split_once('=').unwrap();
    assert_eq!(with_head(&served, &format!("{host}Cookie: a=b; {own}; c=d\r\n")), 200);
    for cookie in [
        format!("{name}=",),
        format!("{name}={}", &word[1..]),
        format!("{name}={}", served.token),
        format!("judder_explorer_1={word}"),
        format!("x{name}={word}"),
        word.to_owned(),
    ] {
        assert_eq!(with_head(&served, &format!("{host}Cookie: {cookie}\r\n")), 403, "{cookie}");
    }
    let other = Served::new();
    assert_eq!(with_head(&other, &format!("Host: 127.0.0.1:{}\r\nCookie: {own}\r\n", other.port)), 403);
}

#[test]
fn the_cookie_is_out_of_reach_of_scripts_and_other_sites() {
    let served = Served::new();
    let request = format!(
        "GET /enter?token={} HTTP/1.1\r\nHost: localhost:{}\r\nConnection: close\r\n\r\n",
        served.token, served.port
    );
    let answer = served.send(&request);
    let cookie = answer.header("set-cookie").unwrap();
    for part in ["HttpOnly", "SameSite=Strict", "Path=/"] {
        assert!(cookie.split("; ").any(|found| found == part), "{cookie}");
    }
    assert!(!cookie.contains(&served.token), "the cookie is another secret");
    assert_eq!(answer.header("referrer-policy"), Some("no-referrer"));
    assert_eq!(answer.header("cache-control"), Some("no-store"));
}

#[test]
fn names_that_somebody_made_point_here_are_refused() {
    let served = Served::new();
    let (port, cookie) = (served.port, format!("Cookie: {}\r\n", served.cookie()));
    for host in [format!("127.0.0.1:{port}"), format!("localhost:{port}")] {
        assert_eq!(with_head(&served, &format!("Host: {host}\r\n{cookie}")), 200, "{host}");
    }
    let foreign = [
        format!("judder.example:{port}"),
        "127.0.0.1".to_owned(),
        "localhost".to_owned(),
        format!("127.0.0.1:{}", port ^ 1),
        format!("127.0.0.1:{port}.example"),
        format!("127.0.0.2:{port}"),
        format!("[::1]:{port}"),
        format!("x@127.0.0.1:{port}"),
        String::new(),
    ];
    for host in foreign {
        let status = with_head(&served, &format!("Host: {host}\r\n{cookie}"));
        assert!(status == 421 || status == 400, "`{host}`: {status}");
    }
    for heads in [
        cookie.clone(),
        format!("Host: 127.0.0.1:{port}\r\nHost: judder.example:{port}\r\n{cookie}"),
        format!("Host: judder.example:{port}\r\nHost: 127.0.0.1:{port}\r\n{cookie}"),
    ] {
        let status = with_head(&served, &heads);
        assert!(status == 421 || status == 400, "{heads}: {status}");
    }
    // an address in the request line does not speak for the host
    let absolute = served.send(&format!(
        "GET http://127.0.0.1:{port}/api/session HTTP/1.1\r\nHost: judder.example\r\n{cookie}Connection: close\r\n\r\n"
    ));
    assert_eq!(absolute.status, 421);
}

#[test]
fn pages_of_other_sites_are_refused() {
    let served = Served::new();
    let (port, cookie) = (served.port, served.cookie());
    let post = |origin: &str| {
        served
            .send(&format!(
                "POST /api/case HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n{origin}Cookie: {cookie}\r\n\
                 Content-Type: application/json\r\nContent-Length: 2\r\nConnection: close\r\n\r\n{{}}"
            ))
            .status
    };
    assert_eq!(post(&format!("Origin: http://127.0.0.1:{port}\r\n")), 200);
    for origin in [
        String::new(),
        "Origin: null\r\n".to_owned(),
        "Origin: http://judder.example\r\n".to_owned(),
        format!("Origin: https://127.0.0.1:{port}\r\n"),
        "Origin: http://127.0.0.1\r\n".to_owned(),
        format!("Origin: http://127.0.0.1:{}\r\n", port ^ 1),
        format!("Origin: http://127.0.0.1:{port}.example\r\n"),
        format!("Origin: http://127.0.0.1:{port}\r\nOrigin: http://judder.example\r\n"),
    ] {
        assert_eq!(post(&origin), 403, "{origin}");
    }
    let look = format!("Host: 127.0.0.1:{port}\r\nOrigin: http://judder.example\r\nCookie: {cookie}\r\n");
    assert_eq!(with_head(&served, &look), 403);
}

#[test]
fn every_answer_is_bound_to_this_server() {
    let served = Served::new();
    let wrong = json!({ "set": ["operation.velocity=1 N"] });
    for answer in [
        served.get("/"),
        served.get("/nothing"),
        served.get("/api/session"),
        served.post("/api/point", &wrong),
        served.send("GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n"),
    ] {
        let policy = answer.header("content-security-policy").unwrap_or_else(|| panic!("{answer:?}"));
        for part in [
            "default-src 'none'",
            "script-src 'self'",
            "connect-src 'self'",
            "frame-ancestors 'none'",
            "form-action 'none'",
            "base-uri 'none'",
        ] {
            assert!(policy.split("; ").any(|found| found == part), "{policy}");
        }
        assert!(!policy.contains("unsafe") && !policy.contains("http"), "{policy}");
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"));
        assert_eq!(answer.header("cross-origin-resource-policy"), Some("same-origin"));
        assert!(answer.header("access-control-allow-origin").is_none());
    }
}

#[test]
fn no_path_of_a_request_reaches_a_file() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("secret.txt"), "the secret of the test").unwrap();
    let secret = folder.path().join("secret.txt").display().to_string();
    let served = Served::new();
    let climbs = "../".repeat(12);
    let encoded = "%2e%2e/".repeat(12);
    for path in [
        format!("/{climbs}etc/passwd"),
        format!("/assets/{climbs}etc/passwd"),
        format!("/assets/{encoded}etc/passwd"),
        "/assets/..%2f..%2f..%2f..%2fetc%2fpasswd".to_owned(),
        format!("/{secret}"),
        format!("//{secret}"),
        format!("/assets/{secret}"),
        format!("/api/study/sound/{climbs}etc/passwd"),
        format!("/api/study/sound/{encoded}etc/passwd"),
        format!("/api/study/sound/{secret}"),
        "/Cargo.toml".to_owned(),
        "/src/lib.rs".to_owned(),
        "/api/study/sound/x%00.wav".to_owned(),
        "/assets\\..\\..\\Cargo.toml".to_owned(),
    ] {
        let answer = served.get(&path);
        assert!([400, 404].contains(&answer.status), "{path}: {}", answer.status);
        assert!(!answer.text().contains("root:") && !answer.text().contains("the secret"), "{path}");
    }
}

#[test]
fn options_and_analyses_name_no_files() {
    let folder = tempfile::tempdir().unwrap();
    let (there, gone) = (folder.path().join("law.json"), folder.path().join("gone.json"));
    std::fs::write(&there, "{}").unwrap();
    let served = Served::new();
    let about = |option: String| {
        let answer = served.post("/api/point", &json!({ "set": [option] }));
        (answer.status, answer.error().replace("law.json", "F").replace("gone.json", "F"))
    };
    for form in [
        "contact.law={ file = \"F\" }",
        "contact.law.file=F",
        "substrate.dma={ file = \"F\" }",
        "indenter.shape={ heights = \"F\" }",
    ] {
        let of = |path: &std::path::Path| about(form.replace('F', &path.display().to_string()));
        let answers = (of(&there), of(&gone));
        assert_eq!(answers.0.0, 400, "{form}");
        assert_eq!(answers.0, answers.1, "whether a file is there is told to nobody");
    }
    let analysis = json!({ "analysis": { "name": "x", "kind": "motion", "law": { "file": there } } });
    let answer = served.post("/api/motion", &analysis);
    assert!(answer.status == 400 && answer.text().contains("a page names no file"), "{answer:?}");
    // nor within lists, whether it is there or not
    let answers = [&there, &gone].map(|path| {
        let forces =
            json!([{ "structure": "pad", "set": "x-min", "direction": "x", "force": { "file": path } }]);
        let analysis = json!({ "analysis": { "name": "x", "kind": "march", "forces": forces } });
        served.post("/api/analysis", &analysis).text()
    });
    assert!(answers[0].contains("a page names no file"), "{answers:?}");
    assert_eq!(answers[0], answers[1]);
}

#[test]
fn bodies_are_read_within_limits() {
    let served = Served::new();
    let long = json!({ "set": ["x".repeat(70_000)] });
    assert_eq!(served.post("/api/point", &long).status, 413);
    let many = json!({ "set": vec!["operation.velocity=1"; 65] });
    assert_eq!(served.post("/api/point", &many).status, 413);
    for body in ["", "{", "[3]", "{\"set\": 3}", "{\"sett\": []}", "{\"set\": [\"a\u{0}\"]}", "\u{feff}{}"] {
        let answer = served.send(&served.request("/api/point", body));
        assert_eq!(answer.status, 400, "{body}");
        assert!(answer.error().len() > 10);
    }
    let deep = format!("{{\"analysis\": {{\"a\": {}{}}}}}", "[".repeat(20_000), "]".repeat(20_000));
    assert_eq!(served.send(&served.request("/api/analysis", &deep)).status, 400);
    let other = served.request("/api/point", "{}").replace("application/json", "text/plain");
    assert_eq!(served.send(&other).status, 415);
    let claimed =
        served.request("/api/point", "{}").replace("Content-Length: 2", "Content-Length: 99999999999");
    assert_eq!(served.send(&claimed).status, 413);
    let head = format!("Host: 127.0.0.1:{}\r\nX: {}\r\n", served.port, "x".repeat(300_000));
    let status = with_head(&served, &head);
    assert!([431, 400, 0].contains(&status), "{status}");
}

#[test]
fn who_sends_slowly_is_not_waited_for() {
    let served = Served::new();
    let mut slow_head = served.connect();
    slow_head.write_all(b"GET / HTTP/1.1\r\nHost: ").unwrap();
    let mut slow_body = served.connect();
    let request = served.request("/api/point", "{\"set\": []}");
    slow_body.write_all(&request.as_bytes()[..request.len() - 5]).unwrap();
    let body = crate::client::Answer::read(&mut slow_body);
    assert_eq!(body.status, 408, "{body:?}");
    let head = crate::client::Answer::read(&mut slow_head);
    assert!([0, 408].contains(&head.status), "{head:?}");
}

#[test]
fn connections_that_say_nothing_keep_nobody_out() {
    let served = Served::new();
    let cookie = served.cookie();
    // more than there are connections, none of which has been let in
    let silent: Vec<_> = (0..140)
        .map(|index| {
            let mut stream = served.connect();
            if index % 2 == 0 {
                stream.write_all(b"GET / HTTP/1.1\r\nHost: ").unwrap();
            }
            stream
        })
        .collect();
    let start = Instant::now();
    let head = format!("Host: 127.0.0.1:{}\r\nCookie: {cookie}\r\n", served.port);
    assert_eq!(with_head(&served, &head), 200);
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    drop(silent);
}

#[test]
fn who_reads_nothing_is_not_waited_for() {
    let served = Served::new();
    let cookie = served.cookie();
    let of = |cookie: &str| {
        let one = format!("GET / HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n{cookie}\r\n", served.port);
        let many = one.repeat(4000);
        let mut stream = served.connect();
        stream.set_nonblocking(true).unwrap();
        // what does not fit is not sent: a pipe full of questions whose answers nobody fetches
        let _ = stream.write(many.as_bytes());
        stream
    };
    // more than there are connections: of strangers, and of one who is let in
    let strangers: Vec<_> = (0..150).map(|_| of("")).collect();
    assert_eq!(served.get("/api/session").status, 200);
    let guests: Vec<_> = (0..150).map(|_| of(&format!("Cookie: {cookie}\r\n"))).collect();
    assert_eq!(served.get("/api/session").status, 200);
    drop((strangers, guests));
}

#[test]
fn steps_from_other_pages_lead_nowhere() {
    let served = Served::new();
    let own = format!("Host: 127.0.0.1:{}\r\nCookie: {}\r\n", served.port, served.cookie());
    for (site, status) in
        [("same-origin", 200), ("none", 200), ("same-site", 403), ("cross-site", 403), ("x", 403)]
    {
        assert_eq!(with_head(&served, &format!("{own}Sec-Fetch-Site: {site}\r\n")), status, "{site}");
    }
}

#[test]
fn a_mistyped_address_leads_to_the_page() {
    let served = Served::new();
    let look = |path: &str, accept: &str| {
        let cookie = served.cookie();
        let port = served.port;
        served.send(&format!(
            "GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nCookie: {cookie}\r\n{accept}Connection: close\r\n\r\n"
        ))
    };
    let reader = "Accept: text/html,*/*\r\n";
    assert!(look("/mapp", reader).text().contains("<!doctype html"));
    for (path, accept) in
        [("/mapp", ""), ("/api/mapp", reader), ("/secret.txt", reader), ("/assets/x.js", reader)]
    {
        assert_eq!(look(path, accept).status, 404, "{path}");
    }
}

#[test]
fn what_is_no_http_does_no_harm() {
    let served = Served::new();
    for bytes in [
        "\u{0}\u{1}\u{2}\r\n\r\n",
        "GET\r\n\r\n",
        "GET / HTTP/9.9\r\n\r\n",
        "\r\n\r\n\r\n",
        "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    ] {
        let answer = served.send(bytes);
        assert!(answer.status == 0 || answer.status >= 400, "{answer:?}");
    }
    assert_eq!(served.get("/api/session").status, 200);
}
