use super::*;
use crate::{LateralModel, catalog};

const GEOMETRY: Geometry = Geometry {
    wing_area_ft2: 230.0,
    span_ft: 34.0,
    mass_slug: 400.0,
    air_density_slug_ft3: 0.0008,
    true_airspeed_ft_s: 675.0,
};

/// The derivatives of each axis alone come back from those of the equations solved for the accelerations.
#[test]
fn products_of_inertia_are_taken_out() {
    let entry = catalog::PAPER_AIRCRAFT;
    let model = LateralModel::new(entry.derivatives, entry.inertia).unwrap();
    let a = model.a();
    let moment = 0.5 * 0.0008 * 675.0 * 675.0 * 230.0 * 34.0;
    let own = [
        (0, By::Angle, entry.derivatives.l_beta_per_s2, entry.derivatives.n_beta_per_s2),
        (1, By::Rate, entry.derivatives.l_p_per_s, entry.derivatives.n_p_per_s),
        (2, By::Rate, entry.derivatives.l_r_per_s, entry.derivatives.n_r_per_s),
    ];
    for (column, by, l, n) in own {
        let scale = nondimensional(&GEOMETRY, &entry.inertia, by).unwrap();
        let found = scale * a.fixed_view::<3, 1>(0, column);
        let rate = if by == By::Rate { 2.0 * 675.0 / 34.0 } else { 1.0 };
        let thrust = if column == 0 { entry.derivatives.l_t_beta_per_s2 } else { 0.0 };
        let expected_l = (l + thrust) * entry.inertia.ixx_slug_ft2 / moment * rate;
        let thrust = if column == 0 { entry.derivatives.n_t_beta_per_s2 } else { 0.0 };
        let expected_n = (n + thrust) * entry.inertia.izz_slug_ft2 / moment * rate;
        assert!((found[1] - expected_l).abs() < 1e-12 * expected_l.abs().max(1e-3), "{column}");
        assert!((found[2] - expected_n).abs() < 1e-12 * expected_n.abs().max(1e-3), "{column}");
    }
}

#[test]
fn numbers_that_cannot_be_are_refused() {
    let inertia = catalog::PAPER_AIRCRAFT.inertia;
    let none = Geometry { span_ft: 0.0, ..GEOMETRY };
    assert!(nondimensional(&none, &inertia, By::Angle).is_err());
    let endless = Geometry { mass_slug: f64::INFINITY, ..GEOMETRY };
    assert!(nondimensional(&endless, &inertia, By::Rate).is_err());
    let no_body = Inertia { ixz_slug_ft2: 1e9, ..inertia };
    assert!(nondimensional(&GEOMETRY, &no_body, By::Angle).is_err());
}
