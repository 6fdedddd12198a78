//! The page is a part of the program: a page built anew makes a program built anew.

fn main() {
    println!("cargo:rerun-if-changed=page");
}
