//! Which judder this is: what studies are stamped with, and what the hashes of their results name.

use std::sync::OnceLock;

static OF_THE_PROGRAM: OnceLock<&'static str> = OnceLock::new();

/// Names the version of the program that the engine is a part of, with the sources it was built from: another one computes everything again.
/// The first name stays, since a program has one.
pub fn name_version(version: &'static str) {
    let _ = OF_THE_PROGRAM.set(version);
}

/// The version that studies are stamped with: the number, a `+` and the sources where the program knows them, such as `0.1.0+4d3b94b50f1e`;
/// the number of the library where no program has named one.
#[must_use]
pub fn version() -> &'static str {
    OF_THE_PROGRAM.get().copied().unwrap_or(env!("CARGO_PKG_VERSION"))
}

/// What made a file of a study: the [`version`], and the processor by what results may depend on, such as
/// `0.1.0+4d3b94b50f1e on x86_64 with AVX-512`.
#[must_use]
pub fn maker() -> &'static str {
    static MAKER: OnceLock<String> = OnceLock::new();
    MAKER.get_or_init(|| format!("{} on {}{}", version(), std::env::consts::ARCH, vectors()))
}

/// The vector instructions among which libraries choose when they run, as the end of a sentence.
fn vectors() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx512f") {
            return " with AVX-512";
        }
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            return " with AVX2";
        }
    }
    ""
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_maker_is_version_and_processor() {
        let (made, processor) = maker().split_once(" on ").unwrap();
        assert_eq!(made, version());
        assert!(processor.starts_with(std::env::consts::ARCH));
    }
}
