// SPDX-License-Identifier: Apache-2.0
// A shared library without a controller.
extern "C" __attribute__((visibility("default"))) int not_a_controller() { return 0; }
