//! Mirrors made of fields, each of which is one: what is said of all of them.

/// The methods of a `Rate` by its fields: those that copies set, those that sums have, and those whose numbers are coordinates.
macro_rules! fieldwise_rate {
    ([$($set:tt)*] [$($sum:tt)*] [$($number:tt)*]) => {
        #[inline(always)]
        fn set(&mut self, _base: &Self) {
            $(self.$set.set(&_base.$set);)*
        }
        #[inline(always)]
        fn mix_1(&mut self, _base: &Self, (_u, _a): Term<'_, T, Self>) {
            $(self.$sum.mix_1(&_base.$sum, (_u, &_a.$sum));)*
        }
        #[inline(always)]
        fn mix_2(&mut self, _base: &Self, (_u, _a): Term<'_, T, Self>, (_v, _b): Term<'_, T, Self>) {
            $(self.$sum.mix_2(&_base.$sum, (_u, &_a.$sum), (_v, &_b.$sum));)*
        }
        #[cfg_attr(optimised, inline(always))]
        fn mix_3(
            &mut self,
            _base: &Self,
            (_u, _a): Term<'_, T, Self>,
            (_v, _b): Term<'_, T, Self>,
            (_w, _c): Term<'_, T, Self>,
        ) {
            $(self.$sum.mix_3(&_base.$sum, (_u, &_a.$sum), (_v, &_b.$sum), (_w, &_c.$sum));)*
        }
        #[cfg_attr(optimised, inline(always))]
        fn add_4(
            &mut self,
            (_u, _a): Term<'_, T, Self>,
            (_v, _b): Term<'_, T, Self>,
            (_w, _c): Term<'_, T, Self>,
            (_x, _d): Term<'_, T, Self>,
        ) {
            $(self.$sum.add_4((_u, &_a.$sum), (_v, &_b.$sum), (_w, &_c.$sum), (_x, &_d.$sum));)*
        }
        #[inline(always)]
        fn add(&mut self, _step: &Self) {
            $(Rate::add(&mut self.$sum, &_step.$sum);)*
        }
        #[inline(always)]
        fn scale_onto(&mut self, _u: T::Real, _base: &Self) {
            $(Rate::scale_onto(&mut self.$sum, _u, &_base.$sum);)*
        }
        #[inline(always)]
        fn square_shares(&mut self, _of: &Self, _size: &Self) {
            $(Rate::square_shares(&mut self.$number, &_of.$number, &_size.$number);)*
        }
        #[inline(always)]
        fn visit(&self, _visit: &mut impl FnMut(T)) {
            $(Rate::visit(&self.$number, _visit);)*
        }
        #[inline(always)]
        fn replace(&mut self, _make: &mut impl FnMut(T) -> T) {
            $(Rate::replace(&mut self.$number, _make);)*
        }
        #[inline(always)]
        fn join(&mut self, _other: &Self, _make: &mut impl FnMut(T, T) -> T) {
            $(Rate::join(&mut self.$number, &_other.$number, _make);)*
        }
        #[inline(always)]
        fn all(&self, _other: &Self, _test: &mut impl FnMut(T, T) -> bool) -> bool {
            true $(&& Rate::all(&self.$number, &_other.$number, _test))*
        }
    };
}

/// The methods of a `Retraction` by its fields, each of which has its rates under the same name.
macro_rules! fieldwise_retraction {
    ($($i:tt)*) => {
        #[inline(always)]
        fn each_turn(&self, _rate: &Self::Rate, _visit: &mut impl FnMut([T; 3])) {
            $(self.$i.each_turn(&_rate.$i, _visit);)*
        }
        #[inline(always)]
        fn retract_rate(&self, _from: &Self, _rate: &mut Self::Rate) {
            $(self.$i.retract_rate(&_from.$i, &mut _rate.$i);)*
        }
        #[inline(always)]
        fn inverse_retract_acceleration(&self, _from: &Self, _rate: &Self::Rate, _acceleration: &mut Self::Rate) {
            $(self.$i.inverse_retract_acceleration(&_from.$i, &_rate.$i, &mut _acceleration.$i);)*
        }
        #[inline(always)]
        fn transposed_acceleration(&self, _from: &Self, _costate: &mut Self::Rate) {
            $(self.$i.transposed_acceleration(&_from.$i, &mut _costate.$i);)*
        }
        #[cfg_attr(optimised, inline(always))]
        fn transposed_step(
            &self,
            _from: &Self,
            (_rate, _acceleration): (&Self::Rate, &Self::Rate),
            _of_second: &Self::Rate,
            (_of_position, _of_rate): (&mut Self::Rate, &mut Self::Rate),
            _of_from: &mut Self::Rate,
        ) {
            $(
                let here = (&_rate.$i, &_acceleration.$i);
                let of_here = (&mut _of_position.$i, &mut _of_rate.$i);
                self.$i.transposed_step(&_from.$i, here, &_of_second.$i, of_here, &mut _of_from.$i);
            )*
        }
        #[cfg_attr(optimised, inline(always))]
        fn transposed_second(
            &self,
            _from: &Self,
            (_rate, _acceleration): (&Self::Rate, &Self::Rate),
            _of_second: &Self::Rate,
            (_of_position, _of_rate): (&mut Self::Rate, &mut Self::Rate),
            _of_from: &mut Self::Rate,
        ) {
            $(
                let here = (&_rate.$i, &_acceleration.$i);
                let of_here = (&mut _of_position.$i, &mut _of_rate.$i);
                self.$i.transposed_second(&_from.$i, here, &_of_second.$i, of_here, &mut _of_from.$i);
            )*
        }
    };
}

/// The methods of a `Position` by its fields, each of which has its rates under the same name.
macro_rules! fieldwise_position {
    ($($i:tt)*) => {
        #[inline(always)]
        fn drift_0(&mut self, _from: &Self, (_time, _rate): Term<'_, T, Self::Rate>) {
            $(self.$i.drift_0(&_from.$i, (_time, &_rate.$i));)*
        }
        #[cfg_attr(optimised, inline(always))]
        fn drift_1(
            &mut self,
            _from: &Self,
            (_time, _rate): Term<'_, T, Self::Rate>,
            (_u, _a): Term<'_, T, Self::Rate>,
        ) {
            $(self.$i.drift_1(&_from.$i, (_time, &_rate.$i), (_u, &_a.$i));)*
        }
        #[cfg_attr(optimised, inline(always))]
        fn drift_2(
            &mut self,
            _from: &Self,
            (_time, _rate): Term<'_, T, Self::Rate>,
            (_u, _a): Term<'_, T, Self::Rate>,
            (_v, _b): Term<'_, T, Self::Rate>,
        ) {
            $(self.$i.drift_2(&_from.$i, (_time, &_rate.$i), (_u, &_a.$i), (_v, &_b.$i));)*
        }
        #[inline(always)]
        fn displace(&mut self, _step: &Self::Rate) {
            $(self.$i.displace(&_step.$i);)*
        }
        #[inline(always)]
        fn apart(&self, _from: &Self, _displacement: &mut Self::Rate) {
            $(self.$i.apart(&_from.$i, &mut _displacement.$i);)*
        }
        #[inline(always)]
        fn measure(&self, _displacement: &Self::Rate, _note: &mut impl FnMut(T, T)) {
            $(self.$i.measure(&_displacement.$i, _note);)*
        }
        #[inline(always)]
        fn square_shares(&self, _displacement: &Self::Rate, _squares: &mut Self::Rate) {
            $(Position::square_shares(&self.$i, &_displacement.$i, &mut _squares.$i);)*
        }
        #[inline(always)]
        fn visit(&self, _visit: &mut impl FnMut(T)) {
            $(self.$i.visit(_visit);)*
        }
        #[inline(always)]
        fn replace(&mut self, _make: &mut impl FnMut(T) -> T) {
            $(self.$i.replace(_make);)*
        }
        #[inline(always)]
        fn all(&self, _other: &Self, _test: &mut impl FnMut(T, T) -> bool) -> bool {
            true $(&& self.$i.all(&_other.$i, _test))*
        }
        #[inline(always)]
        fn normalise(&mut self) -> bool {
            true $(& self.$i.normalise())*
        }
        fn each_mode(
            &mut self,
            _rate: &mut Self::Rate,
            _acceleration: &Self::Rate,
            _visit: &mut impl FnMut(&mut Mode, &mut T, Told<T>),
        ) {
            $(self.$i.each_mode(&mut _rate.$i, &_acceleration.$i, _visit);)*
        }
        #[inline(always)]
        fn set_clocks(&mut self, _at: T::Real) {
            $(self.$i.set_clocks(_at);)*
        }
        fn stop_clocks(&mut self) {
            $(self.$i.stop_clocks();)*
        }
    };
}

pub(super) use {fieldwise_position, fieldwise_rate, fieldwise_retraction};
