//! The cases are a part of the program: a case that changes makes a program built anew.

fn main() {
    println!("cargo:rerun-if-changed=cases");
}
