//! Loops over columns of derivatives, block by block, so that they vectorise however many there are.

use core::ops::Index;

/// A block of columns on its way from what it is to what it becomes.
pub(crate) struct Block<'a, T, const W: usize> {
    old: &'a mut [T; W],
    new: [T; W],
}

impl<'a, T: Copy, const W: usize> Block<'a, T, W> {
    #[inline(always)]
    pub fn of(old: &'a mut [T; W]) -> Self {
        let new = *old;
        Self { old, new }
    }
    #[inline(always)]
    pub fn set(&mut self, k: usize, value: T) {
        self.new[k] = value;
    }
    #[inline(always)]
    pub fn write(self) {
        *self.old = self.new;
    }
}

impl<T, const W: usize> Index<usize> for Block<'_, T, W> {
    type Output = T;
    #[inline(always)]
    fn index(&self, k: usize) -> &T {
        &self.old[k]
    }
}

/// Sets columns to what expressions make of these and others, for each column `k`: in blocks of eight, of four and one by one, each
/// read as a whole before any of it is written. Expressions may share values that stand before them.
///
/// Left to itself a compiler unrolls a loop over few columns first, and then vectorises the loop over bodies around it, gathering
/// numbers from all over the memory; arrays of many, as values, it copies.
macro_rules! columns {
    ($K:ident; $($read:ident = $from:expr),*; $k:ident: $(let $let:ident = $shared:expr,)* $(mut $write:ident = $to:expr => $value:expr),*) => {{
        $(let $read = <[_; $K]>::as_slice(&$from).as_chunks::<8>();)*
        $(let $write = <[_; $K]>::as_mut_slice(&mut $to).as_chunks_mut::<8>();)*
        for _block in 0..$K / 8 {
            $(let $read = &$read.0[_block];)*
            $(let $write = &mut $write.0[_block];)*
            crate::scalar::columns!(block 8; $k: $(let $let = $shared,)* $(mut $write => $value),*);
        }
        $(let $read = $read.1.as_chunks::<4>();)*
        $(let $write = $write.1.as_chunks_mut::<4>();)*
        for _block in 0..$K % 8 / 4 {
            $(let $read = &$read.0[_block];)*
            $(let $write = &mut $write.0[_block];)*
            crate::scalar::columns!(block 4; $k: $(let $let = $shared,)* $(mut $write => $value),*);
        }
        $(let $read = $read.1.as_chunks::<1>().0;)*
        $(let $write = $write.1.as_chunks_mut::<1>().0;)*
        for _block in 0..$K % 4 {
            $(let $read = &$read[_block];)*
            $(let $write = &mut $write[_block];)*
            crate::scalar::columns!(block 1; $k: $(let $let = $shared,)* $(mut $write => $value),*);
        }
    }};
    (block $W:literal; $k:ident: $(let $let:ident = $shared:expr,)* $(mut $write:ident => $value:expr),*) => {
        $(let mut $write = crate::scalar::Block::<_, $W>::of($write);)*
        for $k in 0..$W {
            $(let $let = $shared;)*
            $(
                let value = $value;
                $write.set($k, value);
            )*
        }
        $($write.write();)*
    };
}
pub(crate) use columns;
