use crate::error::StudyError;

/// Who is told how far a run has come, and who may stop it.
pub trait Progress: Sync {
    /// An analysis of so many steps begins.
    fn begin(&self, name: &str, steps: usize);
    /// So many steps more than were announced have come up.
    fn expect(&self, steps: usize);
    /// One more step of it is done.
    fn advance(&self);
    /// It has ended.
    fn end(&self);
    /// Whether the user wants the run to stop.
    fn interrupted(&self) -> bool;

    /// Something begins that may take a while and has no steps to tell, such as to wait for another process; `None` where it has ended.
    fn announce(&self, _what: Option<&str>) {}

    /// Goes on, if the run is not to stop.
    ///
    /// # Errors
    /// [`StudyError::Interrupted`].
    fn go_on(&self) -> Result<(), StudyError> {
        if self.interrupted() { Err(StudyError::Interrupted) } else { Ok(()) }
    }
}

/// Does what may take a while and has no steps to tell.
pub(crate) fn announced<T>(progress: &dyn Progress, what: &str, work: impl FnOnce() -> T) -> T {
    progress.announce(Some(what));
    let done = work();
    progress.announce(None);
    done
}

/// Tells nothing, and hears that the run is to stop: of what runs within a step.
#[derive(Clone, Copy)]
pub struct Untold<'a>(pub &'a dyn Progress);

impl Progress for Untold<'_> {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {}
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}

/// Tells nobody.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _name: &str, _steps: usize) {}
    fn expect(&self, _steps: usize) {}
    fn advance(&self) {}
    fn end(&self) {}
    fn interrupted(&self) -> bool {
        false
    }
}
