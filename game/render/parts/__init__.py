"""The parts around the table: boxes, cards, gauges and signs."""
