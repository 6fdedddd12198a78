//! Summaries and tables come back exactly; a foreign summary is named as such.

use std::fs;

use judder_store::{AnalysisRecord, Cells, Status, StoreError, StudyFolder, Summary, Table, number};
use serde_json::json;

fn summary() -> Summary {
    let record = |status| AnalysisRecord {
        hash: "0123".to_owned(),
        status,
        wall_time_s: 0.1 + 0.2,
        warnings: vec!["w".to_owned()],
    };
    let failed = Status::Failed { reason: "no root below 1 N".to_owned() };
    let scalars = json!({ "value": [1e-8, 0.1], "full": [[0.2, 0.3], []], "unresolved": 0 });
    Summary {
        case_hash: "abcd".to_owned(),
        version: "0.1.0".to_owned(),
        wall_time_s: 1.5,
        results: [("a".to_owned(), scalars.as_object().unwrap().clone())].into(),
        analyses: [("a".to_owned(), record(Status::Done)), ("b".to_owned(), record(failed))].into(),
        warnings: vec!["beyond the range".to_owned()],
        case: json!({ "model": "oscillator" }),
        extra: json!({ "host": { "threads": 2 } }).as_object().unwrap().clone(),
    }
}

#[test]
fn a_summary_comes_back_and_has_its_plain_keys() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    study.write_summary(&summary(), Some("a")).unwrap();
    assert_eq!(study.read_summary().unwrap().unwrap(), summary());
    let text = fs::read_to_string(folder.path().join("summary.json")).unwrap();
    let plain: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(plain["results"]["a"]["full"], json!([[0.2, 0.3], []]));
    assert_eq!(plain["analyses"]["b"]["status"], "failed");
    assert_eq!(plain["analyses"]["b"]["reason"], "no root below 1 N");
    assert_eq!(plain["host"]["threads"], 2);
}

#[test]
fn numbers_that_json_has_not_become_null_or_an_error() {
    assert_eq!(number(0.1), json!(0.1));
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(number(value).is_null());
    }
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    study.write_summary(&summary(), Some("a")).unwrap();
    let refused =
        study.write_summary(&Summary { wall_time_s: f64::NAN, ..summary() }, Some("a")).unwrap_err();
    assert!(matches!(refused, StoreError::SummaryUnwritable { .. }), "{refused}");
    assert_eq!(study.read_summary().unwrap().unwrap(), summary());
}

#[test]
fn a_foreign_summary_says_what_to_do_and_can_be_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("summary.json");
    for foreign in [&b""[..], b"{", b"[1]", b"{\"name\": 1}", &[0xff, 0xfe, 0x00], b"{\"case_hash\": 3}"] {
        fs::write(&file, foreign).unwrap();
        let study = StudyFolder::create(folder.path()).unwrap();
        let refused = study.read_summary().unwrap_err();
        assert!(matches!(refused, StoreError::SummaryUnreadable { .. }), "{refused}");
        assert!(refused.to_string().contains("--fresh"));
        assert!(study.is_done("a", "h").is_err());
        assert_eq!(fs::read(&file).unwrap(), foreign);
        study.forget(|_| false).unwrap();
        assert!(study.read_summary().unwrap().is_none());
    }
}

#[test]
fn a_table_is_written_with_units_and_shortest_digits() {
    let folder = tempfile::tempdir().unwrap();
    let study = StudyFolder::create(folder.path()).unwrap();
    let table = Table::new()
        .column("velocity", "1", vec![1e-8, 0.1 + 0.2, f64::NAN])
        .unwrap()
        .column("critical load", "N", vec![f64::INFINITY, -0.0, 5e-324])
        .unwrap()
        .column("roots", "", vec![0, 1, i64::MAX])
        .unwrap()
        .column("verdict", "", ["stable", "a, \"b\"", ""].map(String::from).to_vec())
        .unwrap();
    assert_eq!(table.rows(), 3);
    let path = study.write_table("thresholds", &table).unwrap();
    let expected = "velocity,critical load [N],roots,verdict\n1e-8,inf,0,stable\n0.30000000000000004,-0.0,1,\"a, \"\"b\"\"\"\n,5e-324,9223372036854775807,\n";
    assert_eq!(fs::read_to_string(path).unwrap(), expected);
}

#[test]
fn a_ragged_table_is_refused() {
    let table = Table::new().column("a", "1", vec![1.0]).unwrap();
    let refused = table.clone().column("b", "1", vec![1.0, 2.0]).unwrap_err();
    assert!(matches!(refused, StoreError::ColumnLength { expected: 1, found: 2, .. }), "{refused}");
    let refused = table.column("a", "", Cells::I64(vec![1])).unwrap_err();
    assert!(matches!(refused, StoreError::Duplicate { what: "column", .. }), "{refused}");
}

#[test]
fn a_text_is_no_formula_of_a_spreadsheet() {
    let texts = ["=1+1", "@sum", "+cmd", "-1.5", "-x", "a=b"].map(String::from).to_vec();
    let table = Table::new().column("label", "", texts).unwrap();
    assert_eq!(table.to_csv().unwrap(), b"label\n'=1+1\n'@sum\n'+cmd\n-1.5\n'-x\na=b\n");
    let table =
        Table::new().column("=1+1", "m", vec![1.5]).and_then(|t| t.column("-2", "", vec![2.5])).unwrap();
    assert_eq!(table.to_csv().unwrap(), b"'=1+1 [m],-2\n1.5,2.5\n", "a head is a text, too");
}
