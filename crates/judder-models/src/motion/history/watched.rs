//! Samples of a motion, handed on in blocks while it is computed.

use crate::motion::model::Moving;
use judder_oscillator::motion::history::StateSample;
use judder_study::model::SampleBlock;
use std::marker::PhantomData;
use std::mem;
use std::time::{Duration, Instant};

/// Samples that a block has at most.
const BLOCK: usize = 4096;
/// How long samples wait for more at most: a picture of twenty a second stays smooth.
const PATIENCE: Duration = Duration::from_millis(40);

/// Collects samples, and shows them when there are many or the last were shown long ago.
pub(super) struct Blocks<'a, M, const N: usize> {
    block: SampleBlock,
    shown: Instant,
    show: &'a mut dyn FnMut(SampleBlock),
    model: PhantomData<M>,
}

impl<'a, M: Moving<N>, const N: usize> Blocks<'a, M, N> {
    pub(super) fn new(show: &'a mut dyn FnMut(SampleBlock)) -> Self {
        Self { block: Self::empty(), shown: Instant::now(), show, model: PhantomData }
    }

    fn empty() -> SampleBlock {
        let numbers = M::COORDINATES.map(|coordinate| (coordinate.name, Vec::new())).to_vec();
        SampleBlock { numbers, ..SampleBlock::default() }
    }

    pub(super) fn add(&mut self, samples: &[StateSample<N>]) {
        for sample in samples {
            self.block.time.push(sample.time);
            self.block.classes.push(sample.contact_state.number());
            for ((_, values), value) in self.block.numbers.iter_mut().zip(sample.state) {
                values.push(value);
            }
            if self.block.time.len() == BLOCK {
                self.show();
            }
        }
        if self.shown.elapsed() >= PATIENCE {
            self.show();
        }
    }

    /// Shows what waits, if anything does.
    pub(super) fn show(&mut self) {
        self.shown = Instant::now();
        if !self.block.time.is_empty() {
            (self.show)(mem::replace(&mut self.block, Self::empty()));
        }
    }
}
