use crate::data::*;
use lti::*;
use nalgebra::DMatrix;
#[test]
fn measure() {
    let o = oracle();
    for (name, v) in o.as_object().unwrap() {
        let (a, b, c, d) = (matrix(&v["A"]), matrix(&v["B"]), matrix(&v["C"]), matrix(&v["D"]));
        let t = SamplePeriod::new(number(&v["period_s"])).unwrap();
        let s = StateSpace::<Continuous>::new(a.clone(), b.clone(), c, d).unwrap();
        let z = s.zoh(t).unwrap();
        let (ad, bd) = (matrix(&v["Ad"]), matrix(&v["Bd"]));
        println!(
            "{name}: Ad {:.1e} entrywise {:.1e} Bd {:.1e} entrywise {:.1e}",
            relative(z.a(), &ad),
            entrywise(z.a().as_slice(), ad.as_slice()),
            relative(z.b(), &bd),
            entrywise(z.b().as_slice(), bd.as_slice())
        );
        let back = z.inverse_zoh_with_residual();
        match back {
            Ok(r) => println!(
                "   inverse A {:.1e} entry {:.1e} B {:.1e} resid {:.1e} roots {}",
                relative(r.system.a(), &a),
                entrywise(r.system.a().as_slice(), a.as_slice()),
                relative(r.system.b(), &b),
                r.residual,
                r.square_roots
            ),
            Err(e) => println!("   inverse {e}"),
        }
        println!(
            "   poles {:.1e} z {:.1e}  cond {:?}",
            worst_relative(&s.poles().unwrap(), &complexes(&v["poles"])),
            worst_relative(&z.poles().unwrap(), &complexes(&v["poles_z"])),
            s.poles_with_condition()
                .unwrap()
                .iter()
                .map(|p| format!(
                    "{:.1e}/{:.1e}",
                    p.condition,
                    p.entrywise_condition / p.value.norm()
                ))
                .collect::<Vec<_>>()
        );
        let r = s.resolvent_numerators().unwrap();
        println!("   delta {:.1e}", entrywise(r.delta.coefficients(), &numbers(&v["delta"])));
        for i in 0..s.outputs() {
            for j in 0..s.inputs() {
                let mut want = numbers(&v["gamma"][i][j]);
                while want.last() == Some(&0.0) {
                    want.pop();
                }
                let zs = s.subsystem(&[i], &[j]).unwrap().invariant_zeros().unwrap();
                let wz = complexes(&v["zeros"][i][j]);
                if r.numerators[i][j].coefficients().len() != want.len() {
                    println!(
                        "  LEN gamma {i}{j} {:?} {:?}",
                        r.numerators[i][j].coefficients(),
                        want
                    );
                } else {
                    print!(
                        "   gamma {i}{j} {:.1e}",
                        entrywise(r.numerators[i][j].coefficients(), &want)
                    );
                }
                if zs.zeros.len() != wz.len() {
                    println!("   ZEROS {i}{j} {:?} want {:?}", zs, wz);
                } else {
                    println!(
                        " zeros {:.1e} kept {:.1e} dropped {:.1e} res {:.1e} cond {:.1e}",
                        worst_relative(&zs.values(), &wz),
                        zs.smallest_kept,
                        zs.largest_dropped,
                        zs.zeros.iter().map(|z| z.residual).fold(0.0, f64::max),
                        zs.zeros.iter().map(|z| z.condition).fold(0.0, f64::max)
                    );
                }
            }
        }
        let k = v["square"].as_u64().unwrap() as usize;
        let idx: Vec<usize> = (0..k).collect();
        let zs = s.subsystem(&idx, &idx).unwrap().invariant_zeros().unwrap();
        let wz = complexes(&v["square_zeros"]);
        if zs.zeros.len() != wz.len() {
            println!("   SQ ZEROS {:?} want {:?}", zs, wz);
        } else {
            println!("   square zeros {:.1e}", worst_relative(&zs.values(), &wz));
        }
        let f = s.frequency_response(&numbers(&v["frequencies_rad_s"])).unwrap();
        let mut w = 0.0f64;
        for (q, g) in f.iter().enumerate() {
            for i in 0..s.outputs() {
                for j in 0..s.inputs() {
                    let y = complex(&v["response"][q][i][j]);
                    w = w.max((g[(i, j)] - y).norm() / y.norm());
                }
            }
        }
        println!("   response {w:.1e}");
        let _ = DMatrix::<f64>::zeros(0, 0);
    }
}
