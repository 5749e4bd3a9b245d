//! The arities of tuples that are chains.

/// Calls a macro once for each arity with: the type of relation that the tuple meets; for each item its type parameter,
/// its index and the types of the relations it hands on and meets; the items again, from last to first.
#[rustfmt::skip]
macro_rules! for_each_tuple {
    ($make:ident) => {
        $make!(X1; A 0 X0 X1; A 0);
        $make!(X2; A 0 X0 X1, B 1 X1 X2; B 1, A 0);
        $make!(X3; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3; C 2, B 1, A 0);
        $make!(X4; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4; D 3, C 2, B 1, A 0);
        $make!(X5; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5; E 4, D 3, C 2, B 1, A 0);
        $make!(X6; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6; F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X7; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7; G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X8; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8; H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X9; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9; I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X10; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9, J 9 X9 X10; J 9, I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X11; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9, J 9 X9 X10, K 10 X10 X11; K 10, J 9, I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X12; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9, J 9 X9 X10, K 10 X10 X11, N 11 X11 X12; N 11, K 10, J 9, I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X13; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9, J 9 X9 X10, K 10 X10 X11, N 11 X11 X12, O 12 X12 X13; O 12, N 11, K 10, J 9, I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X14; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9, J 9 X9 X10, K 10 X10 X11, N 11 X11 X12, O 12 X12 X13, P 13 X13 X14; P 13, O 12, N 11, K 10, J 9, I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X15; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9, J 9 X9 X10, K 10 X10 X11, N 11 X11 X12, O 12 X12 X13, P 13 X13 X14, Q 14 X14 X15; Q 14, P 13, O 12, N 11, K 10, J 9, I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
        $make!(X16; A 0 X0 X1, B 1 X1 X2, C 2 X2 X3, D 3 X3 X4, E 4 X4 X5, F 5 X5 X6, G 6 X6 X7, H 7 X7 X8, I 8 X8 X9, J 9 X9 X10, K 10 X10 X11, N 11 X11 X12, O 12 X12 X13, P 13 X13 X14, Q 14 X14 X15, U 15 X15 X16; U 15, Q 14, P 13, O 12, N 11, K 10, J 9, I 8, H 7, G 6, F 5, E 4, D 3, C 2, B 1, A 0);
    };
}
pub(crate) use for_each_tuple;
