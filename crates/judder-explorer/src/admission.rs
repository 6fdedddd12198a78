//! Who is let in: requests to this server by its own name, from its own page, by whoever knows the secret.
//!
//! - A `Host` other than this server's own is a name that somebody else made point here (DNS rebinding).
//! - An `Origin` other than this server's own is another site's page; a request that changes or computes something must name it.
//! - The secret stands in the address that the program opens, once; the browser gets a cookie for it, which scripts cannot read and other
//!   sites do not send.

use crate::error::ExplorerError;
use crate::secret::Secret;
use axum::http::header::{COOKIE, HOST, HeaderMap, ORIGIN};
use axum::http::{Method, StatusCode, Uri};

/// The path that takes the secret.
const ENTRANCE: &str = "/enter";

/// What is decided on a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Decision {
    /// It may pass.
    Admitted,
    /// It has brought the secret: it gets this cookie and is sent to the page.
    Welcomed {
        /// The value of `Set-Cookie`.
        cookie: String,
    },
    /// It is refused.
    Refused {
        /// As what.
        status: StatusCode,
        /// Why, for whoever reads it.
        reason: &'static str,
    },
}

/// Who is let in to a server on one port.
#[derive(Debug)]
pub(crate) struct Admission {
    port: u16,
    /// In the opened address.
    token: Secret,
    /// In the cookie: another word, so that an address in a history file is of no use against a restarted server.
    session: Secret,
}

impl Admission {
    pub(crate) fn new(port: u16) -> Result<Self, ExplorerError> {
        Ok(Self { port, token: Secret::new()?, session: Secret::new()? })
    }

    /// The address to open.
    pub(crate) fn address(&self) -> String {
        format!("http://127.0.0.1:{}{ENTRANCE}?token={}", self.port, self.token.word())
    }

    /// Cookies do not know ports: the name tells two servers on this machine apart.
    fn cookie_name(&self) -> String {
        format!("judder_explorer_{}", self.port)
    }

    /// Decides on a request.
    pub(crate) fn admit(&self, method: &Method, uri: &Uri, headers: &HeaderMap) -> Decision {
        let refused = |status, reason| Decision::Refused { status, reason };
        if !self.is_own_host(headers) {
            return refused(StatusCode::MISDIRECTED_REQUEST, "this server answers to its own address alone");
        }
        if !self.is_own_origin(method, headers) {
            return refused(StatusCode::FORBIDDEN, "this server answers its own page alone");
        }
        if uri.path() == ENTRANCE {
            let token = uri.query().and_then(|query| query.strip_prefix("token="));
            return match token.filter(|word| method == Method::GET && self.token.is(word)) {
                Some(_) => Decision::Welcomed { cookie: self.cookie() },
                None => refused(StatusCode::FORBIDDEN, "the address is not the one that judder printed"),
            };
        }
        if !is_step_of_its_own(headers) {
            return refused(
                StatusCode::FORBIDDEN,
                "another site's page leads here; open this address by itself",
            );
        }
        match self.knows_session(headers) {
            true => Decision::Admitted,
            false => refused(
                StatusCode::FORBIDDEN,
                "open the address that judder printed: it lets this browser in",
            ),
        }
    }

    fn cookie(&self) -> String {
        format!("{}={}; Path=/; HttpOnly; SameSite=Strict", self.cookie_name(), self.session.word())
    }

    /// Exactly one `Host`, one of the two names of this server; with its port, which no other server has.
    fn is_own_host(&self, headers: &HeaderMap) -> bool {
        let mut hosts = headers.get_all(HOST).iter();
        let host = hosts.next().and_then(|host| host.to_str().ok());
        hosts.next().is_none() && host.is_some_and(|host| self.names().iter().any(|name| name == host))
    }

    /// An own `Origin`; without one only what a browser sends without one: looking.
    fn is_own_origin(&self, method: &Method, headers: &HeaderMap) -> bool {
        let own = |origin: &str| {
            origin.strip_prefix("http://").is_some_and(|host| self.names().iter().any(|name| name == host))
        };
        let mut origins = headers.get_all(ORIGIN).iter().peekable();
        match origins.peek() {
            None => method == Method::GET || method == Method::HEAD,
            Some(_) => origins.all(|origin| origin.to_str().is_ok_and(own)),
        }
    }

    fn names(&self) -> [String; 2] {
        [format!("127.0.0.1:{}", self.port), format!("localhost:{}", self.port)]
    }

    fn knows_session(&self, headers: &HeaderMap) -> bool {
        let name = self.cookie_name();
        let pairs = headers.get_all(COOKIE).iter().filter_map(|cookies| cookies.to_str().ok());
        let mut pairs =
            pairs.flat_map(|cookies| cookies.split(';')).filter_map(|pair| pair.trim().split_once('='));
        pairs.any(|(key, word)| key == name && self.session.is(word))
    }
}

/// Whether a request is a step of this server's own page or of the user, as far as the browser says: the cookie goes to every port of this
/// machine, so that another server on it may have seen it.
fn is_step_of_its_own(headers: &HeaderMap) -> bool {
    let mut sites = headers.get_all("sec-fetch-site").iter();
    sites.all(|site| site == "same-origin" || site == "none")
}
