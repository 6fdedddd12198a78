//! Matrices.

use super::{each_cut, written};
use crate::file;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use judder_exchange::matrix::read_matrix;
use judder_exchange::{FileCause, FilePlace};
use std::fs;
use std::io::{Cursor, Write};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

fn message(name: &str, content: impl AsRef<[u8]>) -> String {
    let (_folder, path) = written(name, content);
    read_matrix(&path).unwrap_err().to_string()
}

fn sample(name: &str) -> Vec<u8> {
    fs::read(file("validation/matrices").join(name)).unwrap()
}

/// A sample with some bytes replaced.
fn replaced(name: &str, from: &[u8], to: &[u8]) -> Vec<u8> {
    let mut bytes = sample(name);
    let at = bytes.windows(from.len()).position(|window| window == from).unwrap();
    bytes.splice(at..at + from.len(), to.iter().copied());
    bytes
}

#[test]
fn the_name_must_tell_the_format() {
    assert!(message("a.txt", "1").contains("the extension `txt` names no format"));
    assert!(message("a", "1").contains("there are .mtx"));
    let missing = read_matrix(&file("missing.mtx")).unwrap_err();
    assert!(
        matches!(missing.cause(), FileCause::Unreadable { .. })
            && missing.to_string().contains("missing.mtx")
    );
}

#[test]
fn binary_files_are_no_text_and_texts_no_binary_files() {
    assert!(message("a.mtx", sample("sparse.mat")).contains("is no text"));
    assert!(message("a.mtx", [0x31, 0xff, 0xfe]).contains("line 1: is no text: byte 1"));
    assert!(message("a.mat", sample("general.mtx")).contains("its header is not that of version 5"));
    let none = "is no sparse matrix of SciPy: it does not begin as an archive (ZIP) does; write it with";
    assert!(message("a.npz", sample("general.mtx")).contains(none));
    assert!(message("a.mat", b"\x89HDF\r\n\x1a\n").contains("the HDF5 file does not unpack"));
    assert!(message("a.mat", b"MATLAB 7.3 MAT-file").contains("the HDF5 file does not unpack"));
    assert!(message("a.mat", b"MATLAB 5").contains("ends within the header of 128 bytes"));
}

#[test]
fn matlab_files_that_are_cut_or_changed_are_named_with_their_byte() {
    let whole = sample("sparse.mat");
    // behind the header stand the type and the size of the first variable; cut behind it the file is whole
    let first = 136 + u32::from_le_bytes([whole[132], whole[133], whole[134], whole[135]]) as usize;
    assert!(first < whole.len());
    let lengths = (129..whole.len()).filter(|length| *length != first);
    each_cut("a.mat", &whole, lengths, |length, path| {
        let error = read_matrix(path).unwrap_err();
        assert!(matches!(error.place(), FilePlace::Byte(128..)), "{length}: {error}");
    });
    let packed = sample("sparse_compressed.mat");
    each_cut("a.mat", &packed, 129..packed.len(), |length, path| {
        assert!(read_matrix(path).is_err(), "{length}");
    });
    let huge = replaced("sparse.mat", &[14, 0, 0, 0], &[14, 0, 0, 0, 0xff, 0xff, 0xff, 0xff]);
    assert!(message("a.mat", huge).contains("4294967295 bytes are needed"));
}

#[test]
fn archives_that_are_changed_are_named() {
    let whole = sample("csr.npz");
    each_cut("a.npz", &whole, 0..whole.len(), |length, path| {
        let said = read_matrix(path).unwrap_err().to_string();
        assert!(said.ends_with("is missing or broken; was the file cut off?"), "{length}: {said}");
    });
    let mut broken = whole;
    broken[..4].fill(0);
    let said = message("a.npz", broken);
    assert!(said.contains("begin") && !said.contains("zip::"), "{said}");
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    archive.start_file("other.npy", SimpleFileOptions::default()).unwrap();
    let said = message("a.npz", archive.finish().unwrap().into_inner());
    assert!(said.contains("is no sparse matrix of SciPy: its archive has no array `shape`;"), "{said}");
    // a number that no longer fits the checksum
    let stored = replaced("bsr.npz", &1.1_f64.to_le_bytes(), &9.9_f64.to_le_bytes());
    assert!(message("a.npz", stored).contains("does not unpack"));
}

#[test]
fn numbers_that_are_none_and_counts_that_cannot_be_are_refused() {
    let market =
        |rest: &str| message("a.mtx", format!("%%MatrixMarket matrix coordinate real general\n{rest}"));
    assert!(market("2 2 1\n1 1 NaN\n").contains("line 3: `NaN` is no finite number"));
    assert!(market("2 2 1\n1 1 1e999\n").contains("no finite number"));
    assert!(market("2 2 18446744073709551615\n1 1 1\n").contains("says 18446744073709551615 entries"));
    assert!(market("2 2 18446744073709551616\n1 1 1\n").contains("is no whole number from 0 on (entries)"));
    assert!(market("900000000000 900000000000 1\n1 1 1\n").contains("is a number damaged?"));
    assert!(market("2 2\n").contains("line 2: the line of sizes takes rows, columns and entries"));
    assert!(market("").contains("the sizes of the matrix"));
    assert!(market("2 2 3\n1 1 1\n1 1 1\n").contains("says 3 entries, holds 2"));
    let array = |rest: &str| message("a.mtx", format!("%%MatrixMarket matrix array real general\n{rest}"));
    assert!(array("4000000000 4000000000\n1\n").contains("says 16000000000000000000 entries"));
    assert!(message("a.mtx", "1 1 1\n99999999999 1 1\n").contains("is a number damaged?"));
}

/// Its first column has the rows 0, 1 and 4, its second begins at entry 3 and ends at 7.
#[test]
fn matlab_files_of_version_7_3_that_are_changed_are_named() {
    let pointer = |value: u64| value.to_le_bytes();
    let starts = [0, 3, 7].map(pointer).concat();
    let descending = message("a.mat", replaced("sparse_73.mat", &starts, &[0, 9, 7].map(pointer).concat()));
    assert!(descending.contains("column pointers do not ascend"), "{descending}");
    let beyond = message(
        "a.mat",
        replaced("sparse_73.mat", &[1, 4].map(pointer).concat(), &[1, 77].map(pointer).concat()),
    );
    assert!(beyond.contains("a row is 77 (from 0), of 6"), "{beyond}");
    let not_finite = replaced("full_73.mat", &6.6_f64.to_le_bytes(), &f64::NAN.to_le_bytes());
    assert!(message("a.mat", not_finite).contains("NaN at row 6, column 6"));
    let other_class = replaced("full_73.mat", b"double", b"cell\0\0");
    assert!(message("a.mat", other_class).contains("it holds no matrix of numbers"));
    // a matrix of 2^40 rows in a file of some kilobytes
    let tall = replaced("full_73.mat", &[6, 6].map(pointer).concat(), &[6, 1 << 40].map(pointer).concat());
    let said = message("a.mat", tall);
    assert!(said.contains("unpacked bytes") || said.contains("does not unpack"), "{said}");
}

/// Compressed files of some hundred bytes that would unpack to sixteen megabytes, a thousandfold each.
#[test]
fn what_unpacks_to_more_than_it_says_is_refused() {
    const LENGTH: usize = 1 << 24;
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    archive.start_file("shape.npy", SimpleFileOptions::default()).unwrap();
    let header = b"{'descr': '<i8', 'fortran_order': False, 'shape': (2,), }\n";
    archive.write_all(b"\x93NUMPY\x01\x00").unwrap();
    archive.write_all(&(header.len() as u16).to_le_bytes()).unwrap();
    archive.write_all(header).unwrap();
    archive.write_all(&vec![0; LENGTH]).unwrap();
    let archive = archive.finish().unwrap().into_inner();
    assert!(archive.len() < LENGTH / 500);
    let said = message("a.npz", archive);
    assert!(
        said.contains(
            "a NumPy array holds more bytes of data, which are not the 2 numbers that its header says"
        ),
        "{said}"
    );

    // an element that says sixteen bytes
    let mut packed = ZlibEncoder::new(Vec::new(), Compression::best());
    packed.write_all(&[14, 0, 0, 0, 16, 0, 0, 0]).unwrap();
    packed.write_all(&vec![0; LENGTH]).unwrap();
    let packed = packed.finish().unwrap();
    let mut file = sample("sparse.mat")[..128].to_vec();
    file.extend(15_u32.to_le_bytes());
    file.extend((packed.len() as u32).to_le_bytes());
    file.extend(packed);
    assert!(file.len() < LENGTH / 500);
    let said = message("a.mat", file);
    assert!(
        said.contains("byte 136: a compressed element does not unpack: it holds more than the 16 bytes"),
        "{said}"
    );
}

#[test]
fn one_triangle_of_a_whole_matrix_is_refused() {
    let text = "%%MatrixMarket matrix coordinate real general\n2 2 3\n1 1 2\n2 1 -1\n2 2 2\n";
    let said = message("a.mtx", text);
    assert!(said.contains("holds entries (1) in its lower triangle and none in the other"), "{said}");
    assert!(message("a.mtx", "1 1 2\n1 2 1\n2 2 2\n").contains("triangle = \"upper\""));
}
