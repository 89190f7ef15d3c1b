end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
end
END a
end sierra beam
