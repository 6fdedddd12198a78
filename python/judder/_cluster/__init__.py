"""How the chunks of sweeps get to many processes and back.

In the order in which the data flows:

- ``package``: a case with the files that it names, as it travels to a worker.
- ``work``: what a worker does with chunks.
- ``alone``: chunks that end their process, computed in one of their own, at last point by point; ``child``: that process.
- ``executors``: Dask and ``concurrent.futures`` behind one door: submit, wait.
- ``pace``: how many chunks make a task.
- ``dispatch``: hands chunks out, takes results in, does lost ones again.
"""
