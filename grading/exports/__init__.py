"""What is published of the records: one module per format."""
