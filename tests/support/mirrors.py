"""A mirror billiard among the obstacles of a table: a ball of light, with no law and no engine."""

from math import inf, sqrt

from physics.kernel.elementary import direction


def circle(q, v, radius):
    """When a point at q from a circle's centre enters it, or inf."""
    closing, gap = (q.conjugate() * v).real, abs(q) ** 2 - radius**2
    under = closing * closing - gap
    if closing >= 0.0 or under <= 0.0:
        return inf
    time = gap / (sqrt(under) - closing)
    return time if time > 1e-13 else inf


def line(p, v, ends, radius):
    """When a ball at p touches a segment from the left, between its ends, or inf; the normal."""
    along = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
    normal = 1j * along
    speed = (normal.conjugate() * v).real
    gap = (normal.conjugate() * (p - ends[0])).real - radius
    if speed >= 0.0 or gap < -1e-10:
        return inf, normal
    time = max(0.0, -gap / speed)
    foot = (along.conjugate() * (p + time * v - ends[0])).real
    return (time if -1e-13 <= foot <= abs(ends[1] - ends[0]) + 1e-13 else inf), normal


def pocketed(table, p, v, hits=60, home=0j, reach=inf):
    """The pocket in which a ball at p that moves along v, of length 1, ends, or None.

    It is given up after so many hits, or farther from home than it reaches. "away": it has left.
    """
    things = table.obstacles
    segments = [thing.points for thing in things if thing.kind == "segment"]
    points = {(end, 0.0) for ends in segments for end in ends}
    points |= {(thing.points[0], thing.radius) for thing in things if thing.kind == "post"}
    for _ in range(hits):
        when, normal, name = inf, 1j, None
        for thing in things:
            if thing.kind == "pocket":
                time = circle(p - thing.points[0], v, thing.radius)
                if time < when:
                    when, name = time, thing.name
        for ends in segments:
            time, across = line(p, v, ends, table.radius)
            if time < when:
                when, normal, name = time, across, None
        for centre, radius in points:
            time = circle(p - centre, v, radius + table.radius)
            if time < when:
                away = p + time * v - centre
                when, normal, name = time, away / abs(away), None
        if name or when == inf:
            return name or "away"
        p += when * v
        if abs(p - home) > reach:
            return None
        v -= 2.0 * (normal.conjugate() * v).real * normal
    return None


def aimed(table, pocket, axis, angle, offset, start):
    """The pocket in which a ball ends that starts so far before a pocket's mouth, at an angle to
    its axis (degrees; above 0 towards the right of one who looks into it), and past the mouth's
    middle by an offset to the right."""
    way = direction(axis - angle)
    p = pocket - start * way - 1j * offset * way
    return pocketed(table, p, way, home=pocket, reach=start)
