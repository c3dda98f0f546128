use super::*;

fn columns(list: &[(usize, isize)]) -> Vec<Column> {
    list.iter().map(|(channel, lag)| Column::new(*channel, *lag)).collect()
}

#[test]
fn entries_of_one_lag_share_a_sum() {
    // Three block rows of one channel: lags 0, 1, 2 for six entries.
    let plan = Plan::new(1, &columns(&[(0, 0), (0, 1), (0, 2)]), None, 0);
    assert_eq!((plan.pairs.len(), plan.sums), (1, BLOCK));
    let of = |lag: isize| -> Vec<(usize, usize, usize)> {
        plan.entries.iter().filter(|e| e.lag == lag).map(|e| (e.row, e.column, e.start)).collect()
    };
    assert_eq!(of(0), [(0, 0, 0), (1, 1, 1), (2, 2, 2)]);
    assert_eq!(of(1), [(0, 1, 0), (1, 2, 1)]);
    assert_eq!(of(2), [(0, 2, 0)]);
}

#[test]
fn blocks_cover_every_lag_and_start_where_one_is_needed() {
    let plan = Plan::new(2, &columns(&[(0, -30), (0, 0), (1, 9), (1, 10), (1, 40)]), None, -30);
    let across = plan.pairs.iter().find(|pair| (pair.x, pair.y) == (0, 1)).unwrap();
    assert_eq!(across.blocks, [9, 39, 70]);
    for entry in &plan.entries {
        let pair = &plan.pairs[entry.pair];
        let position = entry.sum - pair.offset;
        let first = pair.blocks[position / BLOCK];
        assert_eq!(first + signed(position % BLOCK), entry.lag);
    }
}
