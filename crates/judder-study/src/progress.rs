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
