//! The largest memory that this process has had, as Linux counts it.

/// Bytes; `None` where the system does not tell.
pub(crate) fn peak_bytes() -> Option<u64> {
    high_water_mark(&std::fs::read_to_string("/proc/self/status").ok()?)
}

/// The line `VmHWM:  1234 kB` of /proc/self/status, in bytes.
fn high_water_mark(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let number = line.trim().strip_suffix("kB")?.trim();
    number.parse::<u64>().ok()?.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mark_is_read() {
        assert_eq!(
            high_water_mark("VmPeak:\t  99 kB\nVmHWM:\t    12 kB\nVmRSS:\t 3 kB\n"),
            Some(12_288)
        );
        assert_eq!(high_water_mark("VmPeak:\t  99 kB\n"), None);
        assert_eq!(high_water_mark("VmHWM:\t many kB\n"), None);
    }
}
