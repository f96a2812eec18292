"""The pictures and the page that apps/plot_run.py makes of runs."""
