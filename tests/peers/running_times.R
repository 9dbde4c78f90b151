# SPDX-License-Identifier: MIT
# Lets IOHanalyzer [Doerr et al. 2018] read what `gaitsmith compare --summary CURVES --ioh DIR` wrote, and compares its expected
# running times with ours:  Rscript tests/peers/running_times.R GAITSMITH CURVES OUT
# Writes problem,search,target,ours,theirs. Fails if any differ by more than the six digits that we write.
suppressPackageStartupMessages(library(IOHanalyzer))
arguments <- commandArgs(TRUE)
folder <- tempfile()
text <- system2(arguments[1], c("compare", "--summary", arguments[2], "--ioh", folder), stdout = TRUE)
ours <- read.csv(text = text[seq_len(which(text == "")[1] - 1)])
judged <- do.call(rbind, lapply(DataSetList(folder, verbose = FALSE), function(runs) {
  rows <- ours[ours$search == attr(runs, "algId") & ours$problem == attr(runs, "funcName"), ]
  theirs <- get_RT_summary(runs, ftarget = rows$target, budget = attr(runs, "maxRT"))
  data.frame(rows[c("problem", "search", "target")], ours = rows$ert, theirs = signif(theirs$ERT, 6))
}))
unlink(folder, recursive = TRUE)
stopifnot(nrow(judged) == nrow(ours), nrow(judged) > 0)
judged <- judged[order(as.integer(rownames(judged))), ]
write.csv(judged, arguments[3], row.names = FALSE, quote = FALSE)
same <- judged$ours == judged$theirs | abs(judged$ours - judged$theirs) <= 1e-5 * abs(judged$ours)
cat(sprintf("IOHanalyzer %s: %d of %d expected running times are the same\n", packageVersion("IOHanalyzer"), sum(same), nrow(judged)))
quit(status = if (all(same)) 0 else 1)
