//! Contact cases whose files or numbers cannot be: each is refused with exit code 2, and says where, what is wrong, and what
//! would be right.

use crate::desk::Desk;

/// A contact case with these lines before its only analysis, and these in it.
fn case(lines: &str, analysis: &str) -> String {
    format!("model = \"contact\"\n{lines}\n[[analysis]]\n{analysis}\n")
}

/// A contact under the indenter of these heights.
fn pressed(heights: &str) -> String {
    case(
        &format!("indenter = {{ shape = {{ {heights} }} }}"),
        "kind = \"contact\"\nvelocity = 1e-2\nindentation = 1e-3",
    )
}

/// A substrate from `data.csv`.
fn measured() -> String {
    case("substrate = { dma = { file = \"data.csv\" } }", "kind = \"modulus\"")
}

/// Checks that `run` and `check` refuse a case with this file beside it, name the file, and leave nothing.
fn refused_file(case: &str, name: &str, content: impl AsRef<[u8]>, message: &str, help: &str) {
    let desk = Desk::with_case(case);
    desk.write(name, content);
    for command in ["run", "check"] {
        desk.refused(&[command, "case.toml"], &format!("× {name}: {message}"), &format!("help: {help}"));
    }
}

/// Checks that `run` and `check` refuse a case at this place, and leave nothing.
fn refused_case(case: &str, place: &str, message: &str, help: &str) {
    let desk = Desk::with_case(case);
    for command in ["run", "check"] {
        desk.refused(&[command, "case.toml"], message, help);
        desk.judder(&[command, "case.toml"]).says(place);
    }
}

/// A file in NumPy's format.
fn npy(descr: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    [b"\x93NUMPY\x01\x00", length.as_slice(), header.as_bytes(), data].concat()
}

/// A file of the tests of height files.
fn height_map(name: &str) -> Vec<u8> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../judder-exchange/tests/validation/height_maps/");
    std::fs::read(format!("{folder}{name}")).unwrap()
}

#[test]
fn text_matrices_that_are_none() {
    let case = pressed("heights = \"heights.txt\", spacing = \"1 um\"");
    let refused = |text: &str, message: &str, help: &str| {
        refused_file(&case, "heights.txt", text, message, help);
    };
    refused("", "the file is empty", "a matrix of heights is needed");
    let message = "line 3 of the text matrix has 3 entries, the lines above have 4";
    refused("1 2 3 4\n1 2 3 4\n1 2 3\n", message, "all rows must be equally long");
    let message = "line 2, entry 3 of the text matrix is \"nan\", not a finite number";
    refused("1 2 3 4\n1 2 nan 4\n", message, "mend it, or fill the gap first");
    let message = "line 1 of the text matrix has both commas and spaces between numbers";
    refused("1,5 2,5\n", message, "write decimal points");
    refused("1 2\n3 4\n", "2 × 2 heights are too few", "at least 4 × 4 are needed");
}

#[test]
fn arrays_that_are_none() {
    let case = pressed("heights = \"heights.npy\", spacing = \"1 mm\"");
    let refused = |content: &[u8], message: &str, help: &str| {
        refused_file(&case, "heights.npy", content, message, help);
    };
    let message = "the .npy file holds numbers of type <i8, and only f4 and f8 are read";
    refused(&npy("<i8", "(4, 4)", &[0; 128]), message, "save it as array.astype('f8')");
    let message = "the .npy file holds an array of shape (16,)";
    refused(&npy("<f8", "(16,)", &[0; 128]), message, "a matrix of shape (rows, columns) is needed");
    let message = "the .npy file holds 100 bytes of data, which are not the 4 × 4 numbers";
    refused(
        &npy("<f8", "(4, 4)", &[0; 100]),
        message,
        "it was cut, or changed: save it anew with numpy.save",
    );
    let heights: Vec<u8> =
        (0..16).flat_map(|k| if k == 6 { f64::NAN } else { f64::from(k) }.to_le_bytes()).collect();
    let message = "the height at row 1, column 2 (counted from 0) is NaN";
    refused(&npy("<f8", "(4, 4)", &heights), message, "fill the gaps first");
    refused(b"1 2 3", "the .npy file does not begin with", "save heights with numpy.save");
    let case = pressed("heights = \"heights.npy\"");
    let flat = npy("<f8", "(4, 4)", &[0; 128]);
    let help = "give `spacing`, the distance of neighbouring heights";
    refused_file(&case, "heights.npy", flat, "the file has no coordinates", help);
}

#[test]
fn netcdf_files_that_are_ambiguous() {
    let case = pressed("heights = \"heights.nc\"");
    let refused = |name: &str, message: &str, help: &str| {
        refused_file(&case, "heights.nc", height_map(name), message, help);
    };
    let message = "several variables of the NetCDF file could be the heights";
    refused("two_variables.nc", message, "set `variable` to one of \"z\", \"error\"");
    let help = "interpolate the heights to square cells first";
    refused("oblong.nc", "the steps of the coordinates along x (1) and y (0.5) differ", help);
    refused("two_units.nc", "the heights are in \"nm\"", "bring them to one unit");
    refused("write.py", "the file cannot be read as NetCDF", "if it is such a file, `nccopy -k classic");
    let case = pressed("heights = \"heights.nc\", spacing = \"1 um\"");
    let message = "the coordinates of the file have steps of 0.5 m, `spacing` is 1e-6 m";
    let help = "leave `spacing` out, or mend `unit`";
    refused_file(&case, "heights.nc", height_map("classic.nc"), message, help);
}

#[test]
fn height_files_of_no_known_form() {
    let case = pressed("heights = \"heights.dem\", spacing = \"1 um\"");
    let message = "the ending \"dem\" says nothing about the form of the heights";
    refused_file(&case, "heights.dem", "1 2", message, "they are read from .npy");
    let desk = Desk::with_case(&pressed("heights = \"folder.npy\""));
    std::fs::create_dir(desk.path("folder.npy")).unwrap();
    let message = "`indenter.shape.heights` names `folder.npy`, which is a folder, not a file";
    desk.refused(&["run", "case.toml"], message, "relative to the folder of the case file");
    let desk = Desk::with_case(&pressed("heights = \"none.npy\""));
    desk.refused(&["run", "case.toml"], "names `none.npy`, which does not exist", "case.toml:2:");
}

#[test]
fn measured_moduli_that_are_none() {
    const HEAD: &str = "frequency [Hz],E' [MPa],E'' [MPa]\n";
    let refused = |content: &[u8], message: &str, help: &str| {
        refused_file(&measured(), "data.csv", content, message, help);
    };
    let rows = |rows: &str, message: &str, help: &str| {
        refused(format!("{HEAD}{rows}").as_bytes(), message, help);
    };
    refused(b"", "there are no measurements", "a header line such as `frequency [Hz]");
    let message = "the frequency in line 4 is 10 Hz and does not rise above 20 Hz, the one before";
    rows("1,2,0.3\n20,3,0.4\n10,4,0.5\n", message, "sort the lines by temperature, then frequency");
    let help = "it must be a finite number with a decimal point";
    rows("1,2,nan\n", "the loss modulus in line 2 is `nan`", help);
    rows("1,-2,0.3\n", "the storage modulus in line 2 is -2", "it must be positive");
    rows("1,2\n", "line 2 has 2 fields, the header has 3", "every line needs as many");
    let message = "the column `f` of the header, line 1, is without a unit";
    refused(b"f,E' [MPa],E'' [MPa]\n1,2,3\n", message, "write it in brackets, one of `Hz`, `rad/s`");
    let message = "the header, line 1, has the columns `f [Hz]`, `G' [Pa]`, `G'' [Pa]`";
    refused(b"f [Hz],G' [Pa],G'' [Pa]\n1,2,3\n", message, "one for the storage modulus");
    refused(b"T [\xb0C],f [Hz]\n", "line 1 is not UTF-8 text", "save the file as UTF-8");
    let two = "T [K],f [Hz],E' [MPa],E'' [MPa]\n290,1,2,0.3\n300,1,2,0.3\n";
    let message = "the data are of 2 temperature sweeps";
    refused(two.as_bytes(), message, "give `temperature` and `shift` in [substrate]");
}

#[test]
fn data_of_an_oscillator_that_are_none() {
    let desk = Desk::with_case(
        "model = \"oscillator\"\ncontact = { law = \"hertz\" }\nsubstrate = { dma = { file = \"data.csv\" } }\n",
    );
    desk.write("data.csv", "frequency [Hz],E' [MPa],E'' [MPa]\n1,2,x\n");
    desk.refused(&["run", "case.toml"], "data.csv: the loss modulus in line 2 is `x`", "a finite number");
}

#[test]
fn a_law_file_that_is_none() {
    let desk = Desk::with_case(
        "model = \"oscillator\"\ncontact = { law = { file = \"law.json\" } }\n[[analysis]]\n\
         kind = \"equivalent-damping\"\n\
         sweep = { key = \"operation.velocity\", from = 1e-6, to = 1.0, points = 3, scale = \"log\" }\n",
    );
    desk.write("law.json", "{}");
    for command in ["check", "run"] {
        let message = "law.json: law file: `format` is \"\"";
        desk.refused(&[command, "case.toml"], message, "no file that a contact-law analysis has left");
    }
}

#[test]
fn a_square_that_the_contact_does_not_fit_into() {
    let text = case(
        "indenter = { shape = \"sphere\" }",
        "name = \"tight\"\nkind = \"contact\"\nvelocity = 1e-2\nindentation = 1e-2\ncells = 128\ndomain = 0.1",
    );
    let text = format!("{text}[[analysis]]\nkind = \"modulus\"\n");
    let desk = Desk::with_case(&text);
    let said = desk.judder(&["run", "case.toml", "--json"]);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says("the contact touches the edge of the computed square, whose side is 0.1 R");
    said.says("[case.toml:9:10]");
    let needed = said.stderr.split("give `domain` = ").nth(1).unwrap().split(' ').next().unwrap();
    // the rest of the case is there
    let document = said.json();
    assert!(document["results"]["modulus"].is_object() && document["results"]["tight"].is_null());
    let reason = document["analyses"]["tight"]["reason"].to_string();
    assert!(reason.contains("touches the edge"), "{document}");
    let mended = text.replace("domain = 0.1", &format!("domain = {needed}\naccuracy = 0.1"));
    desk.write("mended.toml", mended);
    let said = desk.judder(&["run", "mended.toml", "--only", "tight"]);
    assert_eq!(said.code, 0, "domain = {needed}: {}", said.stderr);
}

#[test]
fn depths_and_loads_that_no_indenter_has() {
    let sphere = "indenter = { shape = \"sphere\" }";
    let help = "give far less: a half-space stands for the substrate only while contact and depth are small";
    let deep = case(sphere, "kind = \"contact\"\nvelocity = 1e-2\nindentation = 1.5");
    let message = "the indentation is 1.5 R, and this indenter ends at 1 R";
    refused_case(&deep, "[case.toml:6:15]", message, help);
    let heavy = case(sphere, "kind = \"contact\"\nvelocity = 1e-2\nload = 100");
    refused_case(&heavy, "[case.toml:6:8]", "this load presses the indenter in by", help);
    let overflow = case("", "kind = \"contact\"\nvelocity = 1e-2\nload = 1e300");
    refused_case(&overflow, "[case.toml:6:8]", "this load presses the indenter in by", help);
    let law = case(sphere, "kind = \"contact-law\"\nindentation = { from = 1e-3, to = 2 }");
    refused_case(&law, "[case.toml:5:15]", "the indentation is 2 R", help);
    let trembling = "kind = \"transient\"\nmotion = \"rest\"\nduration = 5\nindentation = 0.95\n\
                     oscillation = { amplitude = 0.1, frequency = 1 }";
    refused_case(&case(sphere, trembling), "[case.toml:7:15]", "the indentation is 1.05 R", help);
}

#[test]
fn a_contact_beyond_the_heights_of_its_file() {
    let text = case(
        "indenter = { shape = { heights = \"heights.npy\", spacing = \"1 mm\" } }",
        "kind = \"contact\"\nvelocity = 1e-2\nindentation = 0.5",
    );
    let desk = Desk::with_case(&text);
    let height = |k: i32| f64::from((k / 16 - 8).pow(2) + (k % 16 - 8).pow(2)) * 1e-6;
    let heights: Vec<u8> = (0..256).flat_map(|k| height(k).to_le_bytes()).collect();
    desk.write("heights.npy", npy("<f8", "(16, 16)", &heights));
    let said = desk.judder(&["run", "case.toml"]);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says("the contact reaches the edge of the heights at x = ");
    said.says("[case.toml:6:15]");
    said.says("help: press less, or give heights of a larger piece");
}

#[test]
fn more_memory_than_the_limit() {
    let contact = "kind = \"contact\"\nvelocity = 1e-2\nindentation = 1e-2";
    let large = case("memory_limit = \"1 GiB\"", &format!("{contact}\ncells = 4096"));
    let message = "4096 × 4096 cells take 3.2 GiB of memory, and the limit is 1.0 GiB";
    refused_case(&large, "[case.toml:7:9]", message, "take fewer cells, or set memory_limit = \"4 GiB\"");
    // an analysis has the last word
    let own = case("memory_limit = \"8 GiB\"", &format!("{contact}\ncells = 512\nmemory_limit = \"9 MiB\""));
    let message = "512 × 512 cells take 53.0 MiB of memory, and the limit is 9.0 MiB";
    refused_case(&own, "[case.toml:7:9]", message, "take fewer cells, or set memory_limit = \"53 MiB\"");
    let long = "kind = \"transient\"\nmotion = \"start\"\nvelocity = 10\nindentation = 1e-2\nduration = 5\n\
                cells = 256\nmemory_limit = \"20 MiB\"";
    refused_case(
        &case("", long),
        "[case.toml:9:9]",
        " × 256 cells take ",
        "take fewer cells, or set memory_limit",
    );
    let wrong = case("memory_limit = \"lots\"", contact);
    refused_case(
        &wrong,
        "[case.toml:2:16]",
        "`memory_limit` is not an amount of memory",
        "write a number of 1 MiB or more with its unit",
    );
    // a grid that is chosen in the course of a run
    let desk = Desk::with_case(&case("memory_limit = \"4 MiB\"", contact));
    let said = desk.judder(&["run", "case.toml"]);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says("128 × 128 cells take 5.5 MiB of memory, and the limit is 4.0 MiB");
}

#[test]
fn motions_that_cannot_be_followed() {
    let text = "kind = \"transient\"\nmotion = \"start\"\nvelocity = 1e3\nindentation = 1e-4\nduration = 50";
    let help = "shorten `duration`, slide or oscillate slower, or take fewer `cells`";
    refused_case(&case("", text), "[case.toml:8:12]", " steps at least, and 100000 are allowed", help);
    let rough = "indenter = { radius = \"1 mm\", shape = { rough = { period = \"1 mm\", cells = 64, hurst = 0.8, \
                 rms_height = \"5 um\" } } }";
    let desk = Desk::with_case(&case(rough, "kind = \"contact\"\nvelocity = \"1 m/s\"\nload = \"20 mN\""));
    let said = desk.judder(&["check", "case.toml"]);
    assert_eq!(said.code, 2, "{}", said.stderr);
    said.says("at this speed the substrate still remembers ");
    said.says("[case.toml:5:12]");
    said.says("help: slide slower, or take a longer period");
}

#[test]
fn substrates_that_cannot_be() {
    let refused = |substrate: &str, message: &str, help: &str| {
        refused_case(&case(substrate, "kind = \"modulus\""), "", message, help);
    };
    refused(
        "substrate = { rubbery_modulus = \"20 MPa\" }",
        "the glassy modulus 1e7 Pa is not above the rubbery modulus 2e7 Pa",
        "E∞ must be above E0, or equal to it for an elastic substrate",
    );
    refused(
        "substrate = { prony = [{ time = \"1 ms\", compliance = \"-1e-7 1/Pa\" }] }",
        "`substrate.prony.compliance` must be positive, but is -1e-7 1/Pa",
        "[case.toml:2:",
    );
    refused(
        "substrate = { temperature = \"-80 degC\", shift = { wlf = { c1 = 17.4, c2 = \"51.6 K\", \
         reference_temperature = \"25 degC\" } } }",
        "the temperature 193.15 K is too low for the WLF formula",
        "it holds above T_ref − C2 = 246.55 K",
    );
}

#[test]
fn continuous_spectra_that_cannot_be() {
    let refused = |continuous: &str, message: &str, help: &str| {
        let substrate = format!("substrate = {{ continuous = {{ {continuous} }} }}");
        refused_case(&case(&substrate, "kind = \"modulus\""), "[case.toml:2:", message, help);
    };
    let sample = |time: &str, density: &str| {
        format!(
            "samples = [{{ time = \"2 ms\", density = \"1e-5 1/Pa/s\" }}, {{ time = \"{time}\", density = \"{density} 1/Pa/s\" }}]"
        )
    };
    refused("terms = 3", "`substrate.continuous` lacks the key `samples`", "give log_normal = {");
    let two = "log_normal = { median = \"1 ms\", width = 1 }, terms = 3, accuracy = 1e-2";
    refused(two, "cannot both be given", "keep `substrate.continuous.terms`");
    let message = "the times of `substrate.continuous.samples` must ascend, but 0.001 s follows 0.002 s";
    refused(&sample("1 ms", "1e-5"), message, "list the terms from the shortest time to the longest");
    let message = "`substrate.continuous.samples.density` must be zero or positive, but is -1e-5 1/Pa/s";
    refused(&sample("3 ms", "-1e-5"), message, "out of range");
    let message = "`substrate.continuous.samples.density` must be a compliance per time";
    refused(&sample("3 ms", "1e-5").replace("1/Pa/s", "1/Pa"), message, "1e-5 1/Pa/s");
    let message = "the range runs backwards";
    refused("power_law = { from = \"1 s\", to = \"1 ms\", exponent = 0.3 }", message, "exchange");
}
