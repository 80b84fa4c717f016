"""Leaves NumPy, warnings, the random generators and the environment in disorder.

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
