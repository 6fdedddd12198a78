//! A server of its own, and a client that sends any bytes: a browser would not let a test lie.

use judder_explorer::{Explorer, ViewedCase};
use serde_json::Value;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

/// A server that ends with the test.
pub(crate) struct Served {
    pub(crate) port: u16,
    pub(crate) token: String,
    stopped: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Served {
    /// The paper's oscillator.
    pub(crate) fn new() -> Self {
        Self::of(None, None)
    }

    pub(crate) fn of(case: Option<&Path>, study: Option<&Path>) -> Self {
        let explorer = Explorer::new(ViewedCase::open(case, study).unwrap(), None).unwrap();
        let address = explorer.address();
        let rest = address.strip_prefix("http://127.0.0.1:").unwrap();
        let (port, token) = rest.split_once("/enter?token=").unwrap();
        let stopped = Arc::new(AtomicBool::new(false));
        let asked = Arc::clone(&stopped);
        let thread = std::thread::spawn(move || explorer.serve(&|| asked.load(Ordering::Relaxed)).unwrap());
        Self { port: port.parse().unwrap(), token: token.to_owned(), stopped, thread: Some(thread) }
    }

    pub(crate) fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
        stream
    }

    /// Sends these bytes and reads to the end.
    pub(crate) fn send(&self, request: &str) -> Answer {
        let mut stream = self.connect();
        stream.write_all(request.as_bytes()).unwrap();
        Answer::read(&mut stream)
    }

    /// `name=value` of the cookie that the token is exchanged for.
    pub(crate) fn cookie(&self) -> String {
        let answer = self.send(&format!(
            "GET /enter?token={} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\n\r\n",
            self.token, self.port
        ));
        assert_eq!(answer.status, 200);
        answer.header("set-cookie").unwrap().split(';').next().unwrap().to_owned()
    }

    pub(crate) fn get(&self, path: &str) -> Answer {
        let cookie = self.cookie();
        self.send(&format!(
            "GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nCookie: {cookie}\r\nConnection: close\r\n\r\n",
            self.port
        ))
    }

    /// The head and body of a request of the page's own.
    pub(crate) fn request(&self, path: &str, body: &str) -> String {
        format!(
            "POST {path} HTTP/1.1\r\nHost: 127.0.0.1:{0}\r\nOrigin: http://127.0.0.1:{0}\r\nCookie: {1}\r\n\
             Content-Type: application/json\r\nContent-Length: {2}\r\nConnection: close\r\n\r\n{body}",
            self.port,
            self.cookie(),
            body.len()
        )
    }

    pub(crate) fn post(&self, path: &str, body: &Value) -> Answer {
        self.send(&self.request(path, &body.to_string()))
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        self.stopped.store(true, Ordering::Relaxed);
        let ended = self.thread.take().map(JoinHandle::join);
        if !std::thread::panicking() {
            ended.unwrap().unwrap();
        }
    }
}

/// What came back.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: Vec<u8>,
}

impl Answer {
    /// Reads to the end of the connection.
    pub(crate) fn read(stream: &mut TcpStream) -> Self {
        let mut bytes = Vec::new();
        // what a server that breaks off has sent is looked at, too
        let _ = stream.read_to_end(&mut bytes);
        let end = bytes.windows(4).position(|window| window == b"\r\n\r\n").unwrap_or(bytes.len());
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
        let body = bytes.get(end + 4..).unwrap_or_default().to_vec();
        let is_chunked = head.to_lowercase().contains("transfer-encoding: chunked");
        Self { status, head, body: if is_chunked { unchunked(&body) } else { body } }
    }

    pub(crate) fn header(&self, name: &str) -> Option<&str> {
        let mut lines = self.head.lines().filter_map(|line| line.split_once(": "));
        lines.find(|(key, _)| key.eq_ignore_ascii_case(name)).map(|(_, value)| value)
    }

    pub(crate) fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    pub(crate) fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|_| panic!("no JSON: {self:?}"))
    }

    /// Message and help of a refusal.
    pub(crate) fn error(&self) -> String {
        let document = self.json();
        format!("{} | {}", document["error"]["message"].as_str().unwrap(), document["error"]["help"])
    }

    /// The frames of a stream: headers with their payloads.
    pub(crate) fn frames(&self) -> Vec<Frame> {
        let (mut frames, mut rest) = (Vec::new(), self.body.as_slice());
        while rest.len() >= 8 {
            let length = |at: usize| u32::from_le_bytes(rest[at..at + 4].try_into().unwrap()) as usize;
            let (header, payload) = (length(0), length(4));
            if rest.len() < 8 + header + payload {
                break;
            }
            let document = serde_json::from_slice(&rest[8..8 + header]).unwrap();
            frames.push(Frame { header: document, payload: rest[8 + header..8 + header + payload].to_vec() });
            rest = &rest[8 + header + payload..];
        }
        frames
    }
}

/// A frame of a stream.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) header: Value,
    payload: Vec<u8>,
}

impl Frame {
    pub(crate) fn kind(&self) -> &str {
        self.header["kind"].as_str().unwrap()
    }

    fn array(&self, name: &str) -> (&Value, &[u8]) {
        let arrays = self.header["arrays"].as_array().unwrap();
        let entry = arrays.iter().find(|entry| entry["name"] == name).unwrap_or_else(|| panic!("no {name}"));
        (entry, &self.payload[entry["offset"].as_u64().unwrap() as usize..])
    }

    fn count(entry: &Value) -> usize {
        entry["shape"].as_array().unwrap().iter().map(|length| length.as_u64().unwrap() as usize).product()
    }

    pub(crate) fn reals(&self, name: &str) -> Vec<f64> {
        let (entry, bytes) = self.array(name);
        let values = bytes.chunks_exact(8).take(Self::count(entry));
        values.map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap())).collect()
    }

    pub(crate) fn codes(&self, name: &str) -> Vec<u8> {
        let (entry, bytes) = self.array(name);
        bytes[..Self::count(entry)].to_vec()
    }
}

fn unchunked(body: &[u8]) -> Vec<u8> {
    let (mut whole, mut rest) = (Vec::new(), body);
    while let Some(end) = rest.windows(2).position(|window| window == b"\r\n") {
        let size = std::str::from_utf8(&rest[..end]).unwrap();
        let size = usize::from_str_radix(size.trim(), 16).unwrap();
        let chunk =
            rest.get(end + 2..end + 2 + size).unwrap_or_else(|| rest.get(end + 2..).unwrap_or_default());
        whole.extend_from_slice(chunk);
        match rest.get(end + 4 + size..) {
            Some(further) if size > 0 => rest = further,
            _ => break,
        }
    }
    whole
}
