"""The limit cycle of the oscillator paper's section 5 with SciPy: what a private script does, written well.

solve_ivp (RK45) inside a contact state, every change of it a terminal event with a direction. Equations (12), (13) and the law (34)-(39)
as printed. Prints one line of JSON: seconds for one period (the least of some runs), the period, and the changes of contact.
"""

import json
import math
import sys
import time

from scipy.integrate import solve_ivp

STIFFNESS, RETARDATION, NORMAL_LOAD, SPEED, DAMPING = 0.00375, 0.4, 7.5e-4, 4e-4, 0.02
RADIUS = STIFFNESS / NORMAL_LOAD
BELT = SPEED * RADIUS / RETARDATION
K11, K12, K22 = 1.5, 0.5, 1.5
TOLERANCE = 1e-8
STICK, BEHIND, AHEAD, AIR = range(4)


def law(speed: float, depth: float) -> tuple[float, float, float]:
    """F_k, A and mu of (34), (36), (38)."""
    v, y = math.log10(max(speed, 1e-300)), math.log10(max(depth, 1e-300))
    force = 11.890 * depth**1.5 * 0.5 * (1.199 + math.erf(0.873 * v - 0.449 * y + 0.412))
    area = 1.440 * depth * (2.118 - math.exp(-((v - (0.493 * y - 1.328)) ** 2) / (2 * 0.826**2)))
    friction = 0.450 * math.sqrt(depth) * math.exp(-((v - (0.489 * y - 1.682)) ** 2) / (2 * 0.766**2))
    return force, area, friction


class Oscillator:
    """The oscillator at one shear strength, friction carried by the normal load."""

    def __init__(self, shear_strength: float) -> None:
        self.adhesion = shear_strength / NORMAL_LOAD

    def field(self, mode: int):
        direction = {BEHIND: -1.0, AHEAD: 1.0}.get(mode, 0.0)

        def field(_, u):
            x, y, vx, vy = u
            structure_x = DAMPING * vx + K11 * x + K12 * y
            structure_y = DAMPING * vy + K22 * y + K12 * x
            if mode == AIR or y <= 0.0:
                return vx, vy, -structure_x, 1.0 - structure_y
            speed = max(direction * (vx - BELT), 0.0) * RETARDATION / RADIUS
            force, area, friction = law(speed, y / RADIUS)
            ax = 0.0 if mode == STICK else -direction * (friction + self.adhesion * area) - structure_x
            return vx, vy, ax, 1.0 - force / NORMAL_LOAD - structure_y

        return field

    def margin(self, u, sign: float) -> float:
        """How far a sticking indenter is from slipping behind (sign 1) or ahead (-1)."""
        x, y, vx, _ = u
        limit = self.adhesion * law(0.0, max(y, 0.0) / RADIUS)[1]
        return limit - sign * (DAMPING * vx + K11 * x + K12 * y)

    def events(self, mode: int, is_armed: bool) -> list:
        guards = {
            STICK: [lambda _, u: u[1], lambda _, u: self.margin(u, 1.0), lambda _, u: self.margin(u, -1.0)],
            BEHIND: [lambda _, u: u[1], lambda _, u: BELT - u[2]],
            AHEAD: [lambda _, u: u[1], lambda _, u: u[2] - BELT],
            AIR: [lambda _, u: -u[1]],
        }[mode]
        if is_armed:
            guards.append(lambda _, u: u[2])
        for event in guards:
            event.terminal, event.direction = True, -1.0
        return guards

    def next_mode(self, mode: int, event: int, u: list) -> int:
        if mode == AIR:
            u[1] = 0.0
            return BEHIND if u[2] < BELT else AHEAD
        if event == 0:
            u[1] = 0.0
            return AIR
        if mode == STICK:
            return BEHIND if event == 1 else AHEAD
        u[2] = BELT
        if self.margin(u, 1.0) < 0.0:
            return BEHIND
        return AHEAD if self.margin(u, -1.0) < 0.0 else STICK

    def period(self, start: list) -> tuple[float, int]:
        """Time and changes of contact until x' falls through zero again; the start lies there, so the section is armed later."""
        u, mode, now, changes = list(start), BEHIND, 0.0, 0
        while True:
            is_armed = now >= 1.0
            until = now + 1e3 if is_armed else 1.0
            events = self.events(mode, is_armed)
            leg = solve_ivp(self.field(mode), (now, until), u, method="RK45", rtol=TOLERANCE, atol=TOLERANCE, events=events)
            now, u = float(leg.t[-1]), [float(c) for c in leg.y[:, -1]]
            if leg.status == 0:
                continue
            event = next(k for k, times in enumerate(leg.t_events) if times.size)
            if is_armed and event == len(events) - 1:
                return now, changes
            mode = self.next_mode(mode, event, u)
            changes += 1
            if changes > 1000:
                sys.exit("the contact changes for ever")


def main() -> None:
    oscillator = Oscillator(float(sys.argv[1]))
    start = [float(number) for number in sys.argv[2:6]]
    least, found = math.inf, None
    for _ in range(3):
        begin = time.perf_counter()
        found = oscillator.period(start)
        least = min(least, time.perf_counter() - begin)
    print(json.dumps({"seconds": least, "period": found[0], "changes": found[1]}))


main()
