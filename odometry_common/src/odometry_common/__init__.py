"""What every node of these packages needs: checked parameters, a safe stop, a clean end."""
