# SPDX-License-Identifier: GPL-3.0-or-later
function(granum_trade_refuses what code message)
  granum_cli_test("trade: ${what}" EXIT ${code} STDERR "^granum: error: ${message}" ARGS trade ${ARGN})
endfunction()
granum_trade_refuses("two contact shapes" 2 "study\\.contacts: trade measures one contact shape"
  --set study.contacts=sphere,cone)
granum_trade_refuses("one seed has no scatter" 2 "study\\.seeds = 1 is outside \\[2, 1000\\]" --seeds 1)
granum_trade_refuses("quick and full at once" 2 "--quick cannot go with --full or --budget" --quick --full)
granum_trade_refuses("budget without unit" 2 "--budget = 600 has no unit" --budget 600)
granum_trade_refuses("budget that is too small" 2 "--budget = 0\\.001 s is outside times of at least [0-9]" --budget 1ms)
granum_trade_refuses("negative budget" 2 "--budget = -1 s is outside" --budget -1s)
granum_trade_refuses("budget of nothing" 2 "--budget = 0 s is outside" --budget 0s)
granum_trade_refuses("unknown key" 2 "key 'grain\\.radios' is unknown" --set grain.radios=1mm)
granum_trade_refuses("redraw and an extent" 2 "--redraw uses the earlier run" --redraw x --quick)
granum_trade_refuses("redraw of nothing" 3 "none/trade\\.csv: " --redraw none)
granum_trade_refuses("folder that is a file" 3 "isotropic\\.csv: cannot be " --out isotropic.csv)

granum_trade_refuses("too few grains for their sizes" 2 "grains = 250 is outside \\[294, 1e7\\]" --quick --set grain.sizes=lognormal:0.35)
