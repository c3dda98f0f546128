//! Links the system's OpenBLAS, which has the LAPACK that Clarabel's semidefinite cone calls, for the feature `regularized`.
//!
//! The crate `openblas-src` would do the same, but its build script needs an HTTP client with TLS even to use an installed library.

use std::io::Write;

fn main() -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    writeln!(out, "cargo::rerun-if-changed=build.rs")?;
    if std::env::var_os("CARGO_FEATURE_REGULARIZED").is_some() {
        writeln!(out, "cargo::rustc-link-lib=dylib=openblas")?;
    }
    Ok(())
}
