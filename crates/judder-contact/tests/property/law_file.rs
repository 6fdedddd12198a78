//! Law files: to the last bit, and nothing but law files.

use crate::synthetic::{collapsed, tabulated};
use judder_contact::law::file::{from_json, to_json};
use judder_contact::law::{LawError, LawIndenter};
use judder_contact::{FittedLaw, Law};
use std::sync::Arc;

fn both() -> [Law; 2] {
    [Law::Collapsed(Arc::new(collapsed(17))), Law::Tabulated(Arc::new(tabulated(LawIndenter::Sphere, 17, 3)))]
}

#[test]
fn a_law_comes_back_to_the_last_bit() {
    for law in both() {
        let text = to_json(&law).unwrap().unwrap();
        let back = from_json(&text).unwrap();
        assert_eq!(back, law);
        assert_eq!(to_json(&back).unwrap().unwrap(), text);
    }
    assert!(to_json(&Law::Fitted(FittedLaw::oscillator_paper())).unwrap().is_none());
}

#[test]
fn what_is_no_law_file_is_refused_with_the_reason() {
    let text = to_json(&both()[1]).unwrap().unwrap();
    let with = |edit: &dyn Fn(&mut serde_json::Value)| {
        let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
        edit(&mut value);
        from_json(&value.to_string()).unwrap_err()
    };
    assert!(matches!(with(&|v| v["format"] = "another".into()), LawError::WrongFormat { .. }));
    assert!(matches!(with(&|v| v["version"] = 2.into()), LawError::WrongVersion { found: 2, understood: 1 }));
    assert!(matches!(
        with(&|v| v["knots"]["ln_speeds"][3] = 0.1.into()),
        LawError::NotUniform { index: 3, .. }
    ));
    assert!(matches!(
        with(&|v| v["values"]["area"][18] = (-1.0).into()),
        LawError::InvalidValue { quantity: "area", column: 1, row: 1, .. }
    ));
    assert!(matches!(
        with(&|v| v["limits"]["fast_friction"] = 7.3.into()),
        LawError::LimitsDisagree { name: "fast_friction", .. }
    ));
    assert!(matches!(
        with(&|v| v["errors"]["solver"]["area"] = (-1.0).into()),
        LawError::InvalidNumber { .. }
    ));
    let missing = with(&|v| {
        v["material"].as_object_mut().unwrap().remove("modulus_ratio");
    });
    assert!(missing.to_string().contains("modulus_ratio"), "{missing}");
    let missing = with(&|v| {
        v["knots"].as_object_mut().unwrap().remove("ln_indentations");
    });
    assert!(missing.to_string().contains("ln_indentations"), "{missing}");
    assert!(matches!(with(&|v| v["extra"] = 1.into()), LawError::Json(_)));
    // null is what a writer makes of NaN
    assert!(matches!(with(&|v| v["values"]["force"][0] = serde_json::Value::Null), LawError::Json(_)));
    assert!(matches!(
        from_json("{\"format\": \"judder-contact-law\", \"version\": NaN}"),
        Err(LawError::Json(_))
    ));
    let short = with(&|v| {
        v["values"]["friction"].as_array_mut().unwrap().pop();
    });
    assert!(matches!(short, LawError::WrongCount { quantity: "friction", found: 50, expected: 51 }));
}
