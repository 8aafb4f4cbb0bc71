"""What the two scripts of this package share."""
