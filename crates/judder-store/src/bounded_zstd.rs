//! The compression of arrays, unpacked to no more than their chunks have: what a damaged or foreign file has packed is not believed.

use std::any::Any;
use std::borrow::Cow;
use std::io;
use std::sync::{Arc, Once};

use judder_memory::MemoryBudget;
use zarrs::array::codec::ZstdCodec;
use zarrs::array::codec::api::{
    CodecRuntimePluginV3, PartialDecoderCapability, PartialEncoderCapability, register_codec_v3,
};
use zarrs::array::{
    ArrayBytesRaw, BytesRepresentation, BytesToBytesCodecTraits, Codec, CodecError, CodecMetadataOptions,
    CodecOptions, CodecTraits, CodecTraitsV3, RecommendedConcurrency,
};
use zarrs::metadata::Configuration;
use zarrs::metadata::v3::MetadataV3;
use zarrs::plugin::{ExtensionName, PluginCreateError, ZarrVersion};
use zstd::bulk::{Decompressor, decompress};

/// The name of the compression in the metadata of arrays.
const NAME: &str = "zstd";

/// The compression of the array library, with an end to what it unpacks.
#[derive(Debug, Clone)]
pub(crate) struct BoundedZstd(ZstdCodec);

/// Makes the array library read with it whatever is compressed so; told before an array is opened.
pub(crate) fn bind() {
    static BOUND: Once = Once::new();
    BOUND.call_once(|| {
        let create = |metadata: &MetadataV3| {
            let Codec::BytesToBytes(_) = ZstdCodec::create(metadata)? else {
                return Err(PluginCreateError::from("this compression takes bytes"));
            };
            Ok(Codec::BytesToBytes(Arc::new(BoundedZstd::new(crate::zarr::COMPRESSION_LEVEL))))
        };
        register_codec_v3(CodecRuntimePluginV3::new(|name| name == NAME, create));
    });
}

impl BoundedZstd {
    /// Of this level, where it packs.
    pub(crate) fn new(level: i32) -> Self {
        Self(ZstdCodec::new(level, false))
    }
}

impl ExtensionName for BoundedZstd {
    fn name(&self, version: ZarrVersion) -> Option<Cow<'static, str>> {
        self.0.name(version)
    }
}

impl CodecTraits for BoundedZstd {
    fn as_any(&self) -> &dyn Any {
        self
    }

    fn configuration(&self, version: ZarrVersion, options: &CodecMetadataOptions) -> Option<Configuration> {
        self.0.configuration(version, options)
    }

    fn partial_decoder_capability(&self) -> PartialDecoderCapability {
        self.0.partial_decoder_capability()
    }

    fn partial_encoder_capability(&self) -> PartialEncoderCapability {
        self.0.partial_encoder_capability()
    }
}

impl BytesToBytesCodecTraits for BoundedZstd {
    fn into_dyn(self: Arc<Self>) -> Arc<dyn BytesToBytesCodecTraits> {
        self
    }

    fn recommended_concurrency(
        &self,
        decoded: &BytesRepresentation,
    ) -> Result<RecommendedConcurrency, CodecError> {
        self.0.recommended_concurrency(decoded)
    }

    fn encoded_representation(&self, decoded: &BytesRepresentation) -> BytesRepresentation {
        self.0.encoded_representation(decoded)
    }

    fn encode<'a>(
        &self,
        decoded: ArrayBytesRaw<'a>,
        options: &CodecOptions,
    ) -> Result<ArrayBytesRaw<'a>, CodecError> {
        self.0.encode(decoded, options)
    }

    fn decode<'a>(
        &self,
        encoded: ArrayBytesRaw<'a>,
        decoded: &BytesRepresentation,
        _options: &CodecOptions,
    ) -> Result<ArrayBytesRaw<'a>, CodecError> {
        let most = match decoded.size().map(usize::try_from) {
            Some(size) => size.unwrap_or(usize::MAX),
            None => room_of_texts(&encoded)?,
        };
        let unpacked = decompress(&encoded, most).map_err(|why| {
            io::Error::new(why.kind(), format!("it does not unpack to {most} bytes: {why}"))
        })?;
        Ok(Cow::Owned(unpacked))
    }
}

/// The bytes that these unpack to at most, where nothing else says how many there are: of texts.
fn room_of_texts(encoded: &[u8]) -> io::Result<usize> {
    let most =
        Decompressor::upper_bound(encoded).ok_or_else(|| io::Error::other("it is packed in another way"))?;
    MemoryBudget::of_process()
        .ask(most as u128)
        .map_err(|beyond| io::Error::other(format!("{beyond}; {}", beyond.remedy())))?;
    Ok(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_is_unpacked_than_the_chunk_has() {
        let codec = BoundedZstd::new(3);
        let options = CodecOptions::default();
        let packed = codec.encode(vec![0; 64 << 20].into(), &options).unwrap();
        assert!(packed.len() < 10_000, "{}", packed.len());
        let unpacked = |size| codec.decode(packed.clone(), &BytesRepresentation::FixedSize(size), &options);
        assert_eq!(unpacked(64 << 20).unwrap().len(), 64 << 20);
        let refused = unpacked(80).unwrap_err().to_string();
        assert!(refused.contains("does not unpack to 80 bytes"), "{refused}");
    }

    #[test]
    fn texts_unpack_to_what_there_is_memory_for() {
        let codec = BoundedZstd::new(3);
        let packed = codec.encode(vec![0; 1 << 20].into(), &CodecOptions::default()).unwrap();
        let unpacked = |among| {
            MemoryBudget::shared(among, || {
                codec.decode(packed.clone(), &BytesRepresentation::UnboundedSize, &CodecOptions::default())
            })
        };
        assert_eq!(unpacked(1).unwrap().len(), 1 << 20);
        assert!(unpacked(1 << 40).unwrap_err().to_string().contains("of memory are needed"));
    }
}
