{s = 'two
lines } {'} {s // "x"} {"a" == 'a'} {s = s // s // s} {_FORMAT = "%.99f"} {PI} {_FORMAT = "%n"} {PI}
