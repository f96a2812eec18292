"""What the programs for pictures share: reading runs and studies, and drawing them."""
