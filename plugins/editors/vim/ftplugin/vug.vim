" SPDX-License-Identifier: Apache-2.0
setlocal commentstring=#\ %s
setlocal comments=:#
setlocal expandtab shiftwidth=2 softtabstop=2
