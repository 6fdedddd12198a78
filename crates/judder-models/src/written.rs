//! Files of other programs, made in memory.

use crate::error::ModelError;
use judder_exchange::ExchangeError;
use std::io::Write;

/// What a writer writes, in memory: the study folder writes files whole or not at all.
pub(crate) fn written(
    write: impl FnOnce(&mut dyn Write) -> Result<(), ExchangeError>,
) -> Result<Vec<u8>, ModelError> {
    let mut bytes = Vec::new();
    write(&mut bytes).map_err(|error| ModelError::Fields(error.to_string()))?;
    Ok(bytes)
}
