//! A reference to a scene will do where a scene does.

use super::dynamics::{Dynamics, Held, StiffDynamics};
use crate::element::{Implicit, Reading};
use crate::error::Error;
use crate::motion::Motion;
use crate::scalar::Scalar;

impl<D: Dynamics<L>, L> Dynamics<L> for &D {
    type Space = D::Space;
    type Scalar = D::Scalar;
    type Position = D::Position;
    type Rate = D::Rate;
    type Closures = D::Closures;
    type Workspace = D::Workspace;

    const CLOSED: bool = D::CLOSED;

    #[inline]
    fn workspace(&self) -> Self::Workspace {
        D::workspace(self)
    }

    #[inline]
    fn still(&self) -> Motion<Self::Scalar, Self::Position, Self::Closures> {
        D::still(self)
    }

    #[inline]
    fn admits(&self, loads: &L) -> Result<(), Error> {
        D::admits(self, loads)
    }

    #[inline]
    fn accelerations(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        position: &Self::Position,
        rate: &Self::Rate,
        loads: &L,
        workspace: &mut Self::Workspace,
        acceleration: &mut Self::Rate,
    ) -> Held<D, L> {
        D::accelerations(self, time, position, rate, loads, workspace, acceleration)
    }

    #[inline]
    fn project(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::Workspace,
    ) {
        D::project(self, motion, loads, workspace)
    }

    #[inline]
    fn assembly_step(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::Workspace,
    ) {
        D::assembly_step(self, motion, loads, workspace)
    }

    #[inline]
    fn independent(
        &self,
        motion: &Motion<Self::Scalar, Self::Position, Self::Closures>,
        workspace: &Self::Workspace,
        least: f64,
        report: &mut impl FnMut(usize, &'static str),
    ) -> Result<(), Error> {
        D::independent(self, motion, workspace, least, report)
    }

    #[inline]
    fn accept(&self, motion: &Motion<Self::Scalar, Self::Position, Self::Closures>) -> Result<(), Error> {
        D::accept(self, motion)
    }

    #[inline]
    fn diagnose(
        &self,
        motion: &Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::Workspace,
    ) -> Error {
        D::diagnose(self, motion, loads, workspace)
    }
}

impl<D: StiffDynamics<L>, L> StiffDynamics<L> for &D {
    const LINEAR: bool = D::LINEAR;

    type StiffWorkspace = D::StiffWorkspace;
    type Gains = D::Gains;

    fn gains<'w>(&self, workspace: &'w Self::StiffWorkspace) -> &'w Self::Gains {
        (**self).gains(workspace)
    }

    fn gains_mut<'w>(&self, workspace: &'w mut Self::StiffWorkspace) -> &'w mut Self::Gains {
        (**self).gains_mut(workspace)
    }

    fn gains_fit(&self, gains: &Self::Gains) -> bool {
        D::gains_fit(self, gains)
    }

    fn copy_gains(&self, from: &Self::Gains, to: &mut Self::Gains) {
        D::copy_gains(self, from, to);
    }

    #[inline]
    fn stiff_workspace(&self) -> Self::StiffWorkspace {
        D::stiff_workspace(self)
    }

    #[inline]
    fn implicit_accelerations(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        at: (&Self::Position, &Self::Rate),
        spring: (&Self::Position, &Self::Rate),
        reading: Reading<'_, Self::Position, Self::Rate>,
        springs: Implicit<<Self::Scalar as Scalar>::Real>,
        loads: &L,
        workspace: &mut Self::StiffWorkspace,
        acceleration: &mut Self::Rate,
    ) -> Held<D, L> {
        D::implicit_accelerations(self, time, at, spring, reading, springs, loads, workspace, acceleration)
    }

    #[inline]
    fn project_stiff(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::StiffWorkspace,
    ) {
        D::project_stiff(self, motion, loads, workspace)
    }
}
