//! The vector widths of the machine, for tests that compare them.

use pulp::Arch;

/// One number at a time, every width beyond that, and what is chosen at run time.
pub(crate) fn widths() -> Vec<Arch> {
    let mut widths = vec![Arch::Scalar];
    #[cfg(target_arch = "x86_64")]
    {
        widths.extend(pulp::x86::V3::try_new().map(Arch::V3));
        widths.extend(pulp::x86::V4::try_new().map(Arch::V4));
    }
    widths.push(Arch::new());
    widths
}
