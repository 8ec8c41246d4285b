"""Teaching with RasterLab: hand out, grade, explain. docs/teaching.md walks through it."""
