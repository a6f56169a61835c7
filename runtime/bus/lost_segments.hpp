// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace caravan::runtime {

/// Whether a message whose memory is gone reads as an empty one: with Fast DDS 2.9.
///
/// A message in shared memory is a note at the reader's port of where it is in the writer's segment. The
/// segment goes with the writer. 2.9 leaves a note that leads to no segment where it is, and tries it again
/// at once, for ever: the reader takes a core, and nothing else that comes to that port is read any more. It
/// happens to a process that was suspended while another one came and went. With this file linked in, the
/// process opens an empty segment then (shm_open), in which Fast DDS finds a message of no bytes.
[[nodiscard]] bool reads_past_lost_segments();

}  // namespace caravan::runtime
