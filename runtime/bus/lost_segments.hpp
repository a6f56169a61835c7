// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace caravan::runtime {

/// Whether a message whose segment is gone is read as an empty one: with Fast DDS 2.9.
///
/// A message in shared memory is an entry at the reader's port that refers to the writer's segment. The
/// segment is removed with the writer. 2.9 keeps an entry that refers to no segment, and retries it at once,
/// without end: the reader uses a whole core, and reads nothing else from that port. This happens to a
/// process that was suspended while another one joined and left. With this file linked in, the process opens
/// an empty segment instead (shm_open), in which Fast DDS finds a message of no bytes.
[[nodiscard]] bool reads_past_lost_segments();

}  // namespace caravan::runtime
