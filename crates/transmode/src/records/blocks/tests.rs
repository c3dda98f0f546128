use std::io::Cursor;

use super::*;
use crate::records::binary::{ByteOrder, Number, Width};

const SAMPLES: u8 = 11;
const CHANNELS: u8 = 3;

/// Channel c of sample k: exact in both widths.
fn value(k: u8, c: u8) -> f64 {
    f64::from(k) * 1.5 - f64::from(c) * 100.0
}

fn encode(value: f64, number: Number) -> Vec<u8> {
    #[expect(clippy::cast_possible_truncation, reason = "the values are exact in four bytes")]
    match (number.width, number.byte_order) {
        (Width::Eight, ByteOrder::Little) => value.to_le_bytes().to_vec(),
        (Width::Eight, ByteOrder::Big) => value.to_be_bytes().to_vec(),
        (Width::Four, ByteOrder::Little) => (value as f32).to_le_bytes().to_vec(),
        (Width::Four, ByteOrder::Big) => (value as f32).to_be_bytes().to_vec(),
    }
}

fn record(layout: Layout, number: Number) -> (Vec<u8>, Placement) {
    let mut bytes = b"header".to_vec();
    let mut add = |k, c| bytes.extend(encode(value(k, c), number));
    match layout {
        Layout::SampleBySample => {
            (0..SAMPLES).for_each(|k| (0..CHANNELS).for_each(|c| add(k, c)));
        }
        Layout::ChannelByChannel => {
            (0..CHANNELS).for_each(|c| (0..SAMPLES).for_each(|k| add(k, c)));
        }
    }
    let shape = [SAMPLES, CHANNELS].map(u64::from);
    let placement = Placement::new(6, shape, layout, number, bytes.len() as u64).unwrap();
    (bytes, placement)
}

#[test]
fn every_sample_comes_once_whatever_the_order_the_number_and_the_block() {
    for layout in [Layout::SampleBySample, Layout::ChannelByChannel] {
        for width in [Width::Four, Width::Eight] {
            for byte_order in [ByteOrder::Little, ByteOrder::Big] {
                let (bytes, placement) = record(layout, Number { width, byte_order });
                for samples in [0, 1, 2, 5, 11, 100] {
                    let source = Cursor::new(&bytes);
                    let mut blocks = Blocks::of_samples(source, placement, [2, 0], samples);
                    let (mut input, mut output) = (Vec::new(), Vec::new());
                    while let Some(block) = blocks.next().unwrap() {
                        assert_eq!(block.first, input.len() as u64);
                        assert!(block.input.len() as u64 <= samples.max(1));
                        input.extend_from_slice(block.input);
                        output.extend_from_slice(block.output);
                    }
                    let expected = |c| (0..SAMPLES).map(|k| value(k, c)).collect::<Vec<_>>();
                    assert_eq!([input, output], [expected(2), expected(0)], "{placement:?}");
                }
            }
        }
    }
}

#[test]
fn a_file_that_shrinks_is_an_error() {
    let number = Number { width: Width::Eight, byte_order: ByteOrder::Little };
    let (bytes, placement) = record(Layout::SampleBySample, number);
    let mut blocks = Blocks::of_samples(Cursor::new(&bytes[..100]), placement, [0, 1], 4);
    assert!(blocks.next().is_err());
}
