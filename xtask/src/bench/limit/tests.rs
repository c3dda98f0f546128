use super::*;

#[test]
fn products_are_counted_once() {
    // One channel, 20 shifted copies: lags 0 to 19, in three blocks of 8.
    let work = lag_products(&Layout::block_hankel(1, 20).unwrap());
    assert_eq!(work, Work { wanted: 20, padded: 24 });
    // Two channels, 3 block rows: 3 lags of each with itself, lags -2 to 2 between them.
    let work = lag_products(&Layout::block_hankel(2, 3).unwrap());
    assert_eq!(work, Work { wanted: 3 + 3 + 5, padded: 24 });
}

#[test]
fn gaps_between_lags_start_new_blocks() {
    let columns = vec![Column { channel: 0, lag: 0 }, Column { channel: 0, lag: 100 }];
    assert_eq!(lag_products(&Layout::new(1, columns).unwrap()), Work { wanted: 2, padded: 16 });
}

#[test]
fn the_paper_has_109() {
    // y_i: lags 0 to 50; y_o: 0 to 3; between them: from 1 - 25 to 4 + 25.
    assert_eq!(lag_products(&ours::cfi_layout(PAPER).unwrap()).wanted, 51 + 4 + 54);
}
