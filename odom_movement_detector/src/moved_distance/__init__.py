"""The arithmetic of the detector, which others use as well."""
