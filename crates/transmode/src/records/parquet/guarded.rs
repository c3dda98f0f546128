//! The library panics on some damaged pages. A damaged file is nobody's bug: it gets a sentence.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// Whether a panic of this thread is expected, so that nothing is printed.
    static EXPECTED: Cell<bool> = const { Cell::new(false) };
}

/// Does the work; `None` where it panics, without a word on standard error. What the work was changing is to be thrown away then.
pub(super) fn guarded<T>(work: impl FnOnce() -> T) -> Option<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |panic| {
            if !EXPECTED.get() {
                before(panic);
            }
        }));
    });
    let outer = EXPECTED.replace(true);
    let result = catch_unwind(AssertUnwindSafe(work));
    EXPECTED.set(outer);
    result.ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_an_absence() {
        assert_eq!(guarded(|| 3), Some(3));
        let list: Vec<u8> = Vec::new();
        assert_eq!(guarded(|| list[list.len()]), None);
        assert_eq!(guarded(|| 4), Some(4));
    }
}
