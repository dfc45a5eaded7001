#!/bin/sh
# SciPy 1.10.1 (Debian python3-scipy 1.10.1-2): solve_ivp counts the start as an event when the event's function is
# nought there, and an event that is terminal then ends the motion before it has begun, with status 1 and the message
# of success.
#
# The guess: a pendulum is let go from rest, and "stop when the velocity is nought" gives half a period. The velocity
# is nought at the start too. A finer tolerance does not help, and a direction only if it happens to be the other one:
# going down from rest counts as a change downwards. Way out: start a moment later, or let the event be the crossing of the lowest point.
#
#> terminal event at t = 0.0, 2 points, status 1
#> with direction +1: 3.708, with direction -1: 0.000
#> half a period, 2 K(1/2): 3.708
. "$(dirname "$0")/room.sh"
debian python3-scipy=1.10.1-2
cat >"$room/ask.py" <<'P'
import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ellipk

def pendulum(t, y): return [y[1], -np.sin(y[0])]

def at_rest(direction):
    def velocity(t, y): return y[1]
    velocity.terminal = True
    velocity.direction = direction
    return solve_ivp(pendulum, [0, 20], [np.pi / 2, 0], rtol=1e-10, atol=1e-10, events=velocity)

r = at_rest(0)
print('terminal event at t = %s, %d points, status %d' % (r.t_events[0][0], len(r.t), r.status))
print('with direction +1: %.3f, with direction -1: %.3f' % tuple(at_rest(d).t_events[0][0] for d in (1, -1)))
print('half a period, 2 K(1/2): %.3f' % (2 * ellipk(.5)))
P
in_room /usr/bin/python3 ask.py >"$room/seen"
as_seen "$room/seen"
