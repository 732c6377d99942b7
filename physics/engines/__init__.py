"""Ways to let time pass: from event to event, in fixed steps, and by springs of Hertz."""
