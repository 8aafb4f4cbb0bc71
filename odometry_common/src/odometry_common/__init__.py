"""Shared by all nodes: checked parameters, a safe stop, a clean exit."""
