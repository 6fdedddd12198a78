//! What every answer may need.

use crate::admission::Admission;
use crate::limiter::{Limiter, RequestWatch};
use crate::refusal::RequestRefusal;
use crate::scheduler::Scheduler;
use crate::subject::ViewedCase;
use axum::extract::State;
use std::sync::Arc;

/// What is explored, who is let in, and how much is computed at a time.
#[derive(Debug)]
pub(crate) struct Site {
    pub(crate) subject: Arc<ViewedCase>,
    pub(crate) admission: Admission,
    pub(crate) scheduler: Arc<Scheduler>,
    /// For what is computed at once: points under a cursor.
    pub(crate) short: Limiter,
    /// For the points of a case whose law has to be computed first: one computes it, the others wait.
    pub(crate) laws: Limiter,
}

/// The site as answers get it.
pub(crate) type SharedSite = State<Arc<Site>>;

impl Site {
    /// Computes an answer in one piece.
    ///
    /// # Errors
    /// What the work refuses, and more requests than are let wait.
    pub(crate) async fn compute<T: Send + 'static>(
        &self,
        work: impl FnOnce(&ViewedCase, &RequestWatch) -> Result<T, RequestRefusal> + Send + 'static,
    ) -> Result<T, RequestRefusal> {
        self.limited(&self.short, work).await
    }

    /// The same for what computes a contact law first.
    ///
    /// # Errors
    /// As [`Site::compute`].
    pub(crate) async fn compute_with_law<T: Send + 'static>(
        &self,
        work: impl FnOnce(&ViewedCase, &RequestWatch) -> Result<T, RequestRefusal> + Send + 'static,
    ) -> Result<T, RequestRefusal> {
        self.limited(&self.laws, work).await
    }

    async fn limited<T: Send + 'static>(
        &self,
        limiter: &Limiter,
        work: impl FnOnce(&ViewedCase, &RequestWatch) -> Result<T, RequestRefusal> + Send + 'static,
    ) -> Result<T, RequestRefusal> {
        let subject = Arc::clone(&self.subject);
        limiter.run(self.scheduler.closing(), move |watch| work(&subject, watch)).await
    }
}
