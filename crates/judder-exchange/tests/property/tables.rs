//! Texts that are no tables are refused, never more.

use judder_exchange::dma_table::read_dma_table;
use judder_exchange::heights::read_heights;
use proptest::prelude::*;
use std::path::Path;

proptest! {
    #[test]
    fn text_that_is_no_table_is_refused_without_panic(text in "[-0-9eE.,;\\[\\]()'fHzPa \n\"]{0,80}") {
        let _ = read_dma_table(&text);
        let _ = read_dma_table(&format!("f [Hz],E' [Pa],E'' [Pa]\n{text}"));
        let _ = read_heights(Path::new("heights.txt"), text.into_bytes(), None);
    }
}
