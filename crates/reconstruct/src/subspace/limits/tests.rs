use super::*;
use crate::Channel;
use lti::SamplePeriod;

fn records(count: usize, sensors: usize, samples: usize) -> Vec<Record> {
    let channel = |j: usize, i: usize| {
        let values = (0..samples).map(|k| ((k * k + 3 * i + j) as f64).sin()).collect();
        Channel::new(format!("y{i}"), values)
    };
    (0..count)
        .map(|j| {
            let channels = (0..sensors).map(|i| channel(j, i)).collect();
            Record::new(format!("{j}"), SamplePeriod::new(1.0).unwrap(), channels).unwrap()
        })
        .collect()
}

fn extent(
    (count, sensors, samples): (usize, usize, usize),
    order: OrderChoice,
    asked: Option<usize>,
) -> Result<(usize, usize), ReconstructError> {
    let records = records(count, sensors, samples);
    let options = Options::default();
    let found = Setting::new(&records, &options)?.extent(order, asked)?;
    Ok((found.block_rows, found.largest_order))
}

#[test]
fn block_rows_by_rule() {
    use OrderChoice::{Fixed, Gap};
    let check = |setting, order, expected| {
        assert_eq!(extent(setting, order, None).unwrap(), expected, "{setting:?} {order:?}");
    };
    // 96 rows in all where the records are long.
    check((2, 3, 2000), Fixed(4), (32, 4));
    check((3, 2, 2000), Fixed(4), (48, 4));
    check((2, 6, 2000), Fixed(4), (16, 4));
    // A third of the columns where they are not.
    check((2, 3, 300), Fixed(4), (30, 4));
    check((2, 3, 99), Fixed(4), (10, 4));
    // What the order needs: two sensors and three records tell n states with 2 n block rows.
    check((3, 2, 400), Fixed(30), (60, 30));
    check((2, 6, 400), Fixed(20), (21, 20));
    // The largest order shrinks with the records.
    check((2, 3, 2000), Gap { largest: 10 }, (32, 10));
    check((2, 3, 60), Gap { largest: 10 }, (6, 5));
    check((3, 2, 60), Gap { largest: 10 }, (8, 4));
}

#[test]
fn the_shortest_record_decides_also_if_it_is_the_quiet_one() {
    let records = records(2, 3, 2000);
    let quiet = self::records(1, 3, 200).remove(0);
    let options = Options { noise: NoiseModel::Quiet(quiet), ..Options::default() };
    let setting = Setting::new(&records, &options).unwrap();
    assert_eq!(setting.extent(OrderChoice::Fixed(4), None).unwrap().block_rows, 20);
}

#[test]
fn the_dimension_of_the_signal() {
    let records = records(2, 3, 100);
    let mut options = Options::default();
    assert_eq!(Setting::new(&records, &options).unwrap().signal_dimension(10, 4, 1), 13);
    options.measurement.feedthrough_sensors = vec![0];
    let setting = Setting::new(&records, &options).unwrap();
    assert_eq!((setting.signal_dimension(10, 4, 1), setting.signal_dimension(10, 4, 2)), (14, 24));
}

#[test]
fn channels_that_are_proportional_in_one_record_only_are_two_sensors() {
    let mut data = records(2, 3, 100);
    let channels = data[0].channels();
    let double = channels[0].values.iter().map(|value| 3.0 * value).collect();
    let channels = vec![channels[0].clone(), channels[1].clone(), Channel::new("y2", double)];
    data[0] = Record::new("0", data[0].period(), channels).unwrap();
    assert!(Setting::new(&data, &Options::default()).is_ok());
}

#[test]
fn proportions() {
    let ramp: Vec<f64> = (0..50).map(f64::from).collect();
    let line: Vec<f64> = ramp.iter().map(|x| 1e3 - 4.0 * x).collect();
    assert!(proportion(&ramp, &line).is_some_and(|factor| (factor + 4.0).abs() < 1e-12));
    let mut bent = line.clone();
    bent[25] += 1e-5;
    assert_eq!(proportion(&ramp, &bent), None);
}
