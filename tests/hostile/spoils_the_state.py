"""Changes the global state of NumPy, warnings, the random generator, the interpreter and the environment.

deserves: 10
"""

import os
import random
import sys
import warnings

import numpy

numpy.seterr(all="raise")
numpy.set_printoptions(threshold=0)
warnings.simplefilter("error")
random.seed(1)
os.environ.clear()
sys.path.clear()
sys.setswitchinterval(1e-6)
sys.stdout = sys.stderr = None
