// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing: the target of this source holds the precompiled headers of the tests.
