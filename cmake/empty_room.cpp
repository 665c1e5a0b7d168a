// removed when every room has a source
