//! The listener on the loopback interface, its limits on connections, its end.

use crate::admission::Admission;
use crate::error::ExplorerError;
use crate::guest::Strangers;
use crate::limiter::Limiter;
use crate::limits::{LAWS, SHORT, too_little_memory};
use crate::routes::router;
use crate::scheduler::Scheduler;
use crate::site::Site;
use crate::subject::ViewedCase;
use axum::Extension;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{sleep, timeout};
use tokio_io_timeout::TimeoutStream;

/// Connections at a time: a browser opens six. Where all are taken, one that has not been let in goes for the next.
const CONNECTIONS: usize = 128;
/// The longest that the head of a request may take to come; an idle connection is closed after it, too.
const HEAD: Duration = Duration::from_secs(15);
/// Bytes of the head of a request, at most: an address may be long.
const HEAD_BYTES: usize = 64 << 10;
/// The longest that a client may leave unread what was sent to it.
const UNREAD: Duration = Duration::from_secs(15);
/// How often the wish to end is looked at.
const LOOK: Duration = Duration::from_millis(50);
/// What answers that are being sent are given at the end.
const FAREWELL: Duration = Duration::from_millis(500);
/// Threads of the network; the work has its own.
const THREADS: usize = 2;

/// The page, ready to be served: the port is taken, nobody is answered yet.
#[derive(Debug)]
pub struct Explorer {
    listener: std::net::TcpListener,
    site: Arc<Site>,
}

impl Explorer {
    /// Takes a port of the loopback interface: this one, or any that is free.
    ///
    /// # Errors
    /// [`ExplorerError::Bind`], [`ExplorerError::NoRandomness`].
    pub fn new(subject: ViewedCase, port: Option<u16>) -> Result<Self, ExplorerError> {
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, port.unwrap_or(0)));
        let failed = |source| ExplorerError::Bind { address, source };
        let listener = std::net::TcpListener::bind(address).map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let port = listener.local_addr().map_err(failed)?.port();
        let site = Site {
            subject: Arc::new(subject),
            admission: Admission::new(port)?,
            scheduler: Arc::new(Scheduler::new()?),
            short: Limiter::new(SHORT),
            laws: Limiter::new(LAWS),
        };
        Ok(Self { listener, site: Arc::new(site) })
    }

    /// The address to open: it holds the token that lets a browser in.
    #[must_use]
    pub fn address(&self) -> String {
        self.site.admission.address()
    }

    /// What whoever opens it should know: that no analysis will have the memory that it takes.
    #[must_use]
    pub fn doubt(&self) -> Option<String> {
        too_little_memory()
    }

    /// Serves the page until `stopped` says so; whatever works then is cancelled.
    ///
    /// # Errors
    /// [`ExplorerError::Start`].
    pub fn serve(self, stopped: &dyn Fn() -> bool) -> Result<(), ExplorerError> {
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(THREADS)
            .enable_all()
            .build()
            .map_err(ExplorerError::Start)?;
        let served = runtime.block_on(self.accept(stopped));
        // a solver amid an iteration is not waited for
        runtime.shutdown_timeout(FAREWELL);
        served
    }

    async fn accept(self, stopped: &dyn Fn() -> bool) -> Result<(), ExplorerError> {
        let Self { listener, site } = self;
        let listener = TcpListener::from_std(listener).map_err(ExplorerError::Start)?;
        let connections = Arc::new(Semaphore::new(CONNECTIONS));
        let strangers = Arc::new(Strangers::default());
        while !stopped() {
            match timeout(LOOK, listener.accept()).await {
                Ok(Ok((stream, _))) => {
                    let Some(room) = room(&connections, &strangers, stopped).await else { break };
                    let (site, strangers) = (Arc::clone(&site), Arc::clone(&strangers));
                    tokio::spawn(async move {
                        answer(stream, site, &strangers).await;
                        drop(room);
                    });
                }
                Ok(Err(error)) => pause(&error).await,
                Err(_) => {}
            }
        }
        drop(listener);
        site.scheduler.close();
        let _ = timeout(FAREWELL, connections.acquire_many(CONNECTIONS as u32)).await;
        Ok(())
    }
}

/// The room of a connection, which a stranger leaves where there is no other; `None` at the end of the server.
async fn room(
    connections: &Arc<Semaphore>,
    strangers: &Strangers,
    stopped: &dyn Fn() -> bool,
) -> Option<OwnedSemaphorePermit> {
    while !stopped() {
        if let Ok(room) = Arc::clone(connections).try_acquire_owned() {
            return Some(room);
        }
        strangers.send_one_away();
        if let Ok(room) = timeout(LOOK, Arc::clone(connections).acquire_owned()).await {
            return room.ok();
        }
    }
    None
}

/// Waits after an error that comes again at once, such as too many open files.
async fn pause(error: &io::Error) {
    let of_this_connection =
        matches!(error.kind(), io::ErrorKind::ConnectionAborted | io::ErrorKind::ConnectionReset);
    if !of_this_connection {
        sleep(LOOK).await;
    }
}

/// Answers the requests of a connection.
async fn answer(stream: TcpStream, site: Arc<Site>, strangers: &Strangers) {
    let guest = strangers.welcome();
    let service = TowerToHyperService::new(router(site).layer(Extension(Arc::clone(&guest))));
    // small frames are sent at once: held back to be joined, a first picture comes 40 ms late
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(UNREAD));
    let connection = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD)
        .max_buf_size(HEAD_BYTES)
        .serve_connection(TokioIo::new(Box::pin(stream)), service);
    tokio::select! {
        // a client that breaks off is no news
        _ = connection => {}
        () = guest.sent_away() => {}
    }
}
