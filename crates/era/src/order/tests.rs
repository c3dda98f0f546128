use super::{Floor, FloorOrigin, Order, OrderReason};
use crate::EraError;

const FLOOR: Floor = Floor { value: 1e-6, origin: FloorOrigin::Rounding };

fn check(order: Order, singular_values: &[f64], expected: (usize, OrderReason)) {
    assert_eq!(order.select(singular_values, FLOOR), expected, "{order:?} of {singular_values:?}");
}

#[test]
fn a_fixed_order_is_capped_by_the_floor_and_by_the_data() {
    let values = [1.0, 0.5, 1e-3, 1e-7];
    check(Order::Fixed(0), &values, (0, OrderReason::Fixed));
    check(Order::Fixed(3), &values, (3, OrderReason::Fixed));
    check(
        Order::Fixed(4),
        &values,
        (3, OrderReason::LimitedByRounding { requested: 4, floor: 1e-6 }),
    );
    check(
        Order::Fixed(9),
        &values[..3],
        (3, OrderReason::LimitedByData { requested: 9, available: 3 }),
    );
    let noisy = Floor { origin: FloorOrigin::Noise, ..FLOOR };
    let limited = OrderReason::LimitedByNoise { requested: 4, floor: 1e-6 };
    assert_eq!(Order::Fixed(4).select(&values, noisy), (3, limited));
}

#[test]
fn a_value_at_the_floor_is_not_above_it() {
    check(
        Order::Fixed(1),
        &[1e-6],
        (0, OrderReason::LimitedByRounding { requested: 1, floor: 1e-6 }),
    );
    check(Order::Gap, &[1e-6, 0.0], (0, OrderReason::NothingAboveFloor { floor: 1e-6 }));
    check(Order::Tolerance(0.1), &[0.0], (0, OrderReason::NothingAboveFloor { floor: 1e-6 }));
}

#[test]
fn a_tolerance_counts_what_exceeds_it() {
    let values = [2.0, 0.5, 1e-3, 1e-5, 1e-7];
    check(Order::Tolerance(0.1), &values, (2, OrderReason::Tolerance { relative: 0.1 }));
    check(Order::Tolerance(0.0), &values, (4, OrderReason::Tolerance { relative: 0.0 }));
    check(
        Order::Tolerance(1e-8),
        &values,
        (4, OrderReason::LimitedByRounding { requested: 5, floor: 1e-6 }),
    );
}

#[test]
fn the_gap_is_the_largest_ratio_and_the_floor_closes_it() {
    check(Order::Gap, &[8.0, 4.0, 1e-2, 5e-3], (2, OrderReason::Gap { ratio: 400.0 }));
    // 1e-9 counts as 1e-6, so that the gap after it is not the largest one.
    check(Order::Gap, &[4.0, 1e-4, 1e-9, 0.0], (1, OrderReason::Gap { ratio: 4.0 / 1e-4 }));
    check(Order::Gap, &[4.0], (1, OrderReason::Gap { ratio: 4.0 / 1e-6 }));
    // The last value has no neighbour to compare with.
    check(Order::Gap, &[4.0, 3.0], (1, OrderReason::Gap { ratio: 4.0 / 3.0 }));
}

#[test]
fn tolerances_out_of_range_are_refused() {
    assert_eq!(Order::Tolerance(1.0).check(), Err(EraError::InvalidTolerance { value: 1.0 }));
    assert_eq!(Order::Tolerance(-0.5).check(), Err(EraError::InvalidTolerance { value: -0.5 }));
    assert!(Order::Tolerance(f64::NAN).check().is_err());
    assert_eq!(Order::Tolerance(0.0).check(), Ok(()));
}

#[test]
fn the_floor_takes_the_largest_of_its_causes() {
    // A 9 by 1 matrix: sums give 9 eps * 8, entries give sqrt(9) eps times the largest parameter.
    let own = Floor::new(9, 1, 8.0, 2.0, None);
    assert_eq!((own.value, own.origin), (72.0 * f64::EPSILON, FloorOrigin::Rounding));
    let shared = Floor::new(9, 1, 8.0, 100.0, Some(0.0));
    assert_eq!((shared.value, shared.origin), (300.0 * f64::EPSILON, FloorOrigin::Rounding));
    let noisy = Floor::new(9, 1, 8.0, 2.0, Some(0.5));
    assert_eq!((noisy.value, noisy.origin), (1.5, FloorOrigin::Noise));
}
