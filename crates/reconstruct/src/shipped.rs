//! Records of the paper's aircraft from `tests/data/records`, for the tests.

use lti::SamplePeriod;

use crate::{Channel, Record};

/// The text of a file.
pub(crate) fn read(name: &str) -> String {
    let file = format!("{}/../../tests/data/records/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(file).unwrap()
}

/// Sideslip, roll rate and yaw rate of one flight.
pub(crate) fn record(name: &str) -> Record {
    let mut channels = ["beta", "p", "r"].map(|sensor| Channel::new(sensor, Vec::new()));
    for line in read(&format!("{name}.csv")).lines().skip(1) {
        for (channel, field) in channels.iter_mut().zip(line.split(',').skip(1)) {
            channel.values.push(field.parse().unwrap());
        }
    }
    Record::new(name, SamplePeriod::new(0.1).unwrap(), channels.to_vec()).unwrap()
}

/// The flight with the aileron and the one with the rudder.
pub(crate) fn pair(name: &str) -> [Record; 2] {
    ["aileron", "rudder"].map(|surface| record(&format!("{name}_{surface}")))
}
