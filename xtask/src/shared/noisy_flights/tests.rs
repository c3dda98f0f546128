use super::*;

fn simulator() -> Simulator {
    Simulator::new().unwrap()
}

fn values(pair: &Pair, record: usize, sensor: usize) -> &[f64] {
    &pair.records[record].channels()[sensor].values
}

#[test]
fn the_noise_has_the_size_it_should_have() {
    let simulator = simulator();
    for excitation in Excitation::ALL {
        let clean = simulator.fly(excitation, f64::INFINITY, 7).unwrap();
        let noisy = simulator.fly(excitation, 10.0, 7).unwrap();
        let less = simulator.fly(excitation, 1000.0, 7).unwrap();
        assert!(clean.levels.iter().all(|level| level.abs() <= 0.0));
        let samples = excitation.samples();
        for sensor in 0..3 {
            let deviation = |record: usize| {
                let x = values(&clean, record, sensor);
                let mean = x.iter().sum::<f64>() / samples as f64;
                (x.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / samples as f64).sqrt()
            };
            let signal = f64::midpoint(deviation(0), deviation(1));
            let mut noise = 0.0;
            for record in 0..2 {
                assert_eq!(noisy.records[record].samples(), samples);
                for k in 0..samples {
                    let y = values(&clean, record, sensor)[k];
                    let large = values(&noisy, record, sensor)[k] - y;
                    let small = values(&less, record, sensor)[k] - y;
                    noise += large * large;
                    // The same noise in another size.
                    assert!((large - 100.0 * small).abs() <= 1e-9 * y.abs().max(large.abs()));
                }
            }
            // The deviation of a deviation is 1 / sqrt(2 N): 3 % with 600 samples.
            let ratio = signal / (noise / (2 * samples) as f64).sqrt();
            assert!((ratio / 10.0 - 1.0).abs() < 0.1, "{excitation:?}: {ratio}");
            assert!((noisy.levels[sensor] / signal - 0.1).abs() < 1e-12);
        }
    }
}

#[test]
fn seeds_and_surfaces_have_noise_of_their_own() {
    let simulator = simulator();
    let noise = |seed, record| {
        let clean = simulator.fly(Excitation::Multistep, f64::INFINITY, seed).unwrap();
        let noisy = simulator.fly(Excitation::Multistep, 30.0, seed).unwrap();
        let pairs = values(&noisy, record, 0).iter().zip(values(&clean, record, 0));
        pairs.map(|(a, b)| a - b).collect::<Vec<_>>()
    };
    let correlation = |x: Vec<f64>, y: Vec<f64>| {
        let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(a, b)| a * b).sum::<f64>();
        dot(&x, &y) / (dot(&x, &x) * dot(&y, &y)).sqrt()
    };
    assert!((correlation(noise(1, 0), noise(1, 0)) - 1.0).abs() < 1e-12);
    assert!(correlation(noise(1, 0), noise(1, 1)).abs() < 0.3);
    assert!(correlation(noise(1, 0), noise(2, 0)).abs() < 0.3);
}
