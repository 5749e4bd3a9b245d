//! Ensembles past one machine: [`spread`] hands the runs of a list of parameters to all processes of an MPI job.
//!
//! Threads of each process share its part, as [`ensemble`] shares it. Start one process a machine, or bind each to its cores: processes
//! that share cores gain nothing.

use catena::simulate::ensemble;
use mpi::Count;
use mpi::datatype::PartitionMut;
use mpi::traits::{Communicator, CommunicatorCollectives, Root};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Where results are gathered.
const ROOT: i32 = 0;

/// What the closure returns for each parameter, in their order, in process 0; nothing in the others.
///
/// All processes call this with the same list. Parameter `k` is run in process `k` modulo their number: neighbours in a list often cost
/// alike. Results travel as bytes of [`postcard`], which keep every bit of a number, so that the list is that of
/// one process if the closure reads nothing but its parameter. An error of one run is a result like others. `progress` is told
/// how many of the process's own runs are done.
///
/// # Errors
/// Results that [`postcard`] cannot write or read, in all processes; more than 2 GiB of them from one process, or from all.
///
/// # Panics
/// None: a panic in a closure ends the job, since the other processes would wait for its results for ever.
pub fn spread<P: Sync, T: Serialize + DeserializeOwned + Send>(
    world: &impl Communicator,
    parameters: &[P],
    progress: impl FnMut(usize) + Send,
    run: impl Fn(&P) -> T + Sync,
) -> Result<Option<Vec<T>>, postcard::Error> {
    let (rank, size) = (world.rank() as usize, world.size() as usize);
    let own: Vec<&P> = parameters.iter().skip(rank).step_by(size).collect();
    let runs = || ensemble(&own).progress(progress).run(|parameter| run(parameter));
    let results = catch_unwind(AssertUnwindSafe(runs)).unwrap_or_else(|_| world.abort(101));
    let bytes = postcard::to_stdvec(&results);
    let Some(parts) = gather(world, bytes.as_deref().unwrap_or_default(), bytes.is_ok())? else {
        return bytes.map(|_| None);
    };
    let parts = parts.iter().map(|part| postcard::from_bytes::<Vec<T>>(part)).collect::<Result<Vec<_>, _>>()?;
    let mut parts: Vec<_> = parts.into_iter().map(Vec::into_iter).collect();
    let whole = (0..parameters.len()).map(|k| parts[k % size].next());
    whole.collect::<Option<_>>().map(Some).ok_or(postcard::Error::DeserializeUnexpectedEnd)
}

/// The bytes of each process, in process 0.
fn gather(world: &impl Communicator, bytes: &[u8], written: bool) -> Result<Option<Vec<Vec<u8>>>, postcard::Error> {
    // Lengths first, to all: where one process has nothing to send, or where they are too long, all know.
    let length = Count::try_from(bytes.len()).ok().filter(|_| written).unwrap_or(-1);
    let mut lengths = vec![0; world.size() as usize];
    world.all_gather_into(&length, &mut lengths[..]);
    let whole = lengths.iter().try_fold(0, |sum: Count, length| sum.checked_add(*length).filter(|_| *length >= 0));
    let whole = whole.ok_or(postcard::Error::SerializeBufferFull)?;
    let root = world.process_at_rank(ROOT);
    if world.rank() != ROOT {
        root.gather_varcount_into(bytes);
        return Ok(None);
    }
    let starts: Vec<Count> =
        lengths.iter().scan(0, |start, length| Some(std::mem::replace(start, *start + length))).collect();
    let mut all = vec![0; whole as usize];
    root.gather_varcount_into_root(bytes, &mut PartitionMut::new(&mut all[..], &lengths[..], &starts[..]));
    let part = |(start, length): (&Count, &Count)| all[*start as usize..][..*length as usize].to_vec();
    Ok(Some(starts.iter().zip(&lengths).map(part).collect()))
}
